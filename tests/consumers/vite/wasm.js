import { HearthFire } from 'hearth-fire';
import url from 'hearth-fire/hearth-engine_bg.wasm?url';

HearthFire.wasmUrl = url;
