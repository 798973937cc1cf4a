import * as Phaser from 'phaser';
import { FireImage } from 'hearth-fire/phaser';

/** A player who carries a torch through a cave. The arrow keys, or a press at either side, move her. */
class Cave extends Phaser.Scene {
  create() {
    const { width, height } = this.scale;
    const floor = height - 70;
    // A rock face, whose tiles the torch lights.
    this.tiles = [];
    for (let x = 20; x < width + 40; x += 40) {
      for (let y = 20; y < height + 40; y += 40) {
        const tile = this.add.rectangle(x, y, 39, 39, 0xffffff);
        const shade = 0.55 + 0.45 * Math.abs(Math.sin(x * 12.9 + y * 78.2) % 1);
        this.tiles.push({ tile, x, y, shade: y > floor ? 0.6 * shade : shade });
      }
    }
    this.player = this.add.container(width / 3, floor);
    const body = (x, y, w, h, colour) => this.player.add(this.add.rectangle(x, y, w, h, colour));
    body(0, -62, 24, 26, 0xc98d63);
    body(0, -32, 34, 38, 0x5a3b2c);
    body(-8, -7, 11, 16, 0x2e221b);
    body(8, -7, 11, 16, 0x2e221b);
    body(26, -46, 34, 9, 0xc98d63);
    body(42, -58, 7, 42, 0x4b3220);
    // A scene's own torch would stay on its wall.
    const values = { fuel_power: 190, source_width: 0.17, turbulence: 1, ember_rate: 70, emission_speed: 1.2, domain_width: 1, domain_height: 1.3, spacing: 0.020817 };
    this.fire = new FireImage(this, { values, warm: 2, quality: 'low', width: 384, height: 384 });
    this.fire.setDisplaySize(250, 250);
    this.add.existing(this.fire);
    this.keys = this.input.keyboard.createCursorKeys();
    this.speed = 0;
  }

  update(_, passed) {
    const { activePointer } = this.input;
    const pressed = activePointer.isDown ? Math.sign(activePointer.x - this.player.x) : 0;
    const goal = 190 * (this.keys.right.isDown - this.keys.left.isDown || pressed);
    this.speed += Math.min(1, passed / 120) * (goal - this.speed);
    this.player.x = Phaser.Math.Clamp(this.player.x + (this.speed * passed) / 1000, 40, this.scale.width - 70);
    if (Math.abs(this.speed) > 20) this.player.y = this.scale.height - 70 - 4 * Math.abs(Math.sin(this.time.now / 90));
    this.fire.target = { x: this.player.x + 42, y: this.player.y - 68 };
    const { x, y, intensity, color } = this.fire.light;
    for (const { tile, x: left, y: top, shade } of this.tiles) {
      const light = (3.4 * intensity * shade) / (0.06 + ((left - x) ** 2 + (top - y) ** 2) / 60000);
      const channel = (shift, base) => Math.round(255 * (1 - Math.exp(-light * (((color >> shift) & 255) / 255) ** 1.6 - base)));
      tile.setFillStyle((channel(16, 0.03) << 16) | (channel(8, 0.032) << 8) | channel(0, 0.045));
    }
  }
}

const game = new Phaser.Game({
  parent: document.querySelector('main'),
  width: innerWidth,
  height: innerHeight,
  backgroundColor: '#07080c',
  banner: false,
  audio: { noAudio: true },
  scene: Cave,
});
// For the tests.
Object.assign(globalThis, { game });
