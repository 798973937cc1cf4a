import { HearthFire } from 'hearth-fire';
import url from 'hearth-fire/wasm/hearth-engine_bg.wasm?url';

HearthFire.wasmUrl = url;
