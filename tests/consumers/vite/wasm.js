import { HearthFire } from 'hearth-fire';
import url from 'hearth-fire/hearth-widget_bg.wasm?url';

HearthFire.wasmUrl = url;
