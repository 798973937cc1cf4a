/** The look of the dialog that saves a fire. WebKit counts the text of a long choice as overflow, unless `contain` clips it. */
export const STYLES = /* css */ `
* { box-sizing: border-box; }
[hidden] { display: none !important; }
dialog {
  inline-size: min(640px, 100vw - 16px); max-block-size: calc(100dvh - 16px); margin: auto; padding: 0; overflow: auto; overscroll-behavior: contain;
  border: 1px solid #5a4c42; border-radius: 14px; background: #1c1613; color: #f4ece4; font: 15px/1.4 system-ui, sans-serif; color-scheme: dark;
}
dialog::backdrop { background: rgb(0 0 0 / 0.5); }
form { padding: 18px 20px; }
h2 { margin: 0 0 10px; font-size: 1.25rem; line-height: 1.2; }
fieldset { margin: 0 0 14px; padding: 0; border: 0; }
legend { position: absolute; inline-size: 1px; block-size: 1px; overflow: hidden; clip-path: inset(50%); }
.kinds { display: grid; grid-template-columns: repeat(5, 1fr); gap: 6px; }
.kinds label { position: relative; }
.kinds input { position: absolute; inset: 0; inline-size: 100%; block-size: 100%; margin: 0; opacity: 0; cursor: pointer; }
.kinds span { display: block; padding: 9px 4px; border: 1px solid #5a4c42; border-radius: 9px; text-align: center; }
.kinds input:checked + span { border-color: #ffb454; background: #4a2c10; font-weight: 600; }
.kinds input:focus-visible + span, select:focus-visible, button:focus-visible, label > input:focus-visible { outline: 3px solid #ffb454; outline-offset: 2px; }
.body { display: grid; grid-template-columns: 220px 1fr; gap: 18px; align-items: start; }
.preview {
  display: grid; place-items: center; inline-size: 100%; aspect-ratio: 1; overflow: hidden; border-radius: 9px;
  background: repeating-conic-gradient(#6c6660 0 25%, #57514c 0 50%) 0 0 / 20px 20px;
}
.preview > * { max-inline-size: 100%; max-block-size: 100%; min-inline-size: 0; min-block-size: 0; object-fit: contain; }
.fields { display: grid; gap: 8px; }
.fields label { display: grid; grid-template-columns: 8.5em minmax(0, 1fr); gap: 8px; align-items: center; min-block-size: 36px; }
select, input[type='number'] {
  min-inline-size: 0; inline-size: 100%; min-block-size: 36px; padding: 4px 8px; border: 1px solid #7a6a5e; border-radius: 7px; background: #120e0c; color: inherit; font: inherit;
}
select { contain: paint; }
input[type='checkbox'] { inline-size: 22px; block-size: 22px; margin: 0; accent-color: #ffb454; }
.about { min-block-size: 1.4em; margin: 14px 0 0; }
[role='alert'] { margin: 6px 0 0; color: #ffb0a0; overflow-wrap: anywhere; }
progress { inline-size: 100%; margin-block-start: 8px; accent-color: #ff8a1e; }
.buttons { display: flex; justify-content: end; gap: 10px; margin-block-start: 12px; }
button { min-block-size: 42px; padding: 6px 20px; border: 1px solid #7a6a5e; border-radius: 9px; background: none; color: inherit; font: inherit; cursor: pointer; }
button[type='submit'] { border-color: #ffb454; background: #ffb454; color: #201408; font-weight: 600; }
button:disabled { opacity: 0.5; cursor: default; }
.note { margin: 12px 0 0; color: #c8bab0; font-size: 13px; }
@media (max-width: 560px) {
  .body { grid-template-columns: 1fr; }
  .preview { inline-size: min(100%, 34dvh); margin: auto; }
}
`;
