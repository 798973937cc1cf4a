// Compiled in the page, which needs no build of Angular's own.
import '@angular/compiler';
import 'hearth-fire';
import { CUSTOM_ELEMENTS_SCHEMA, Component, provideZonelessChangeDetection, signal } from '@angular/core';
import { bootstrapApplication } from '@angular/platform-browser';

class Page {
  width = signal(0.3);
  there = signal(true);
  particles = signal(0);

  constructor() {
    // For the test.
    const page = {
      set: (name, value) => this[name].set(value),
      get: () => ({ width: this.width(), particles: this.particles() }),
    };
    Object.assign(window, { page });
  }

  changed({ detail }) {
    if (detail.id === 'source_width') this.width.set(detail.value);
  }
}

const Root = Component({
  selector: '#root',
  schemas: [CUSTOM_ELEMENTS_SCHEMA],
  template: `
    @if (there()) {
      <hearth-fire
        style="width: 240px; height: 240px"
        [attr.source-width]="width()"
        (params-change)="changed($event)"
        (stats)="particles.set($event.detail.particles)"
      ></hearth-fire>
    }
  `,
})(Page);

await bootstrapApplication(Root, { providers: [provideZonelessChangeDetection()] });
