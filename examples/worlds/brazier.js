// The policy of the site allows no code from texts.
import 'pixi.js/unsafe-eval';
import { Application, Container, Graphics } from 'pixi.js';
import { FireSprite } from 'hearth-fire/pixi';

const app = new Application();
await app.init({ resizeTo: window, background: 0x10131c, antialias: true, autoDensity: true });
document.querySelector('main').append(app.canvas);

const world = new Container();
app.stage.addChild(world);

// A wall of stones, each of which the fire lights as it is near.
const stones = [];
for (let row = 0; row < 9; row += 1) {
  for (let column = -7; column < 8; column += 1) {
    const x = column * 74 + (row % 2) * 37;
    const y = -row * 42 - 30;
    const stone = new Graphics().roundRect(x - 35, y - 19, 70, 38, 7).fill(0xffffff);
    world.addChild(stone);
    stones.push({ stone, x, y, shade: 0.75 + 0.25 * Math.sin(7.3 * x + 3.1 * y) });
  }
}
world.addChild(new Graphics().rect(-900, -8, 1800, 300).fill(0x16130f));

const brazier = new Container();
world.addChild(brazier);

const fire = new FireSprite({ warm: 2, values: { source_width: 0.3, fuel_power: 260, source_height: 0.1 } });
fire.height = fire.width = 460;
world.addChild(fire);
// The bowl is before the foot of the flame.
const bowl = new Container();
bowl.addChild(new Graphics().poly([-66, -112, 66, -112, 40, -66, -40, -66]).fill(0x2b2724));
for (const [from, to] of [[-30, -52], [30, 52], [0, 0]]) {
  bowl.addChild(new Graphics().moveTo(from, -68).lineTo(to, 0).stroke({ width: 9, color: 0x221f1c }));
}
world.addChild(bowl);

let at = 0;
const place = () => world.position.set(app.screen.width / 2, Math.min(app.screen.height - 90, 0.8 * app.screen.height));
app.renderer.on('resize', place);
place();
app.stage.eventMode = 'static';
app.stage.hitArea = app.screen;
app.stage.on('pointermove', (event) => event.buttons > 0 && (at = event.global.x - world.x));

app.ticker.add(() => {
  // The brazier is heavy, and the flames lag behind it.
  bowl.x += 0.06 * (at - bowl.x);
  fire.target = { x: bowl.x, y: -108 };
  const { x, y, intensity, color } = fire.light;
  for (const { stone, x: left, y: top, shade } of stones) {
    const light = (3.2 * intensity * shade) / (0.05 + ((left - x) ** 2 + (top - y) ** 2) / 90000);
    const channel = (shift, base) => Math.round(255 * (1 - Math.exp(-light * (((color >> shift) & 255) / 255) ** 1.6 - base)));
    stone.tint = (channel(16, 0.05) << 16) | (channel(8, 0.055) << 8) | channel(0, 0.075);
  }
});
// For the tests.
Object.assign(globalThis, { game: { fire, app, move: (x) => (at = x) } });
