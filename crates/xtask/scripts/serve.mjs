/**
 * Serves a folder on this machine: `node serve.mjs FOLDER [PORT]`. It prints its address,
 * and ends with its standard input.
 */
import { context, stop } from './esbuild.mjs';

/** The port where none is named, if it is free. */
const USUAL_PORT = 8080;

const [servedir, port] = process.argv.slice(2);
const listen = async (/** @type {number} */ number) =>
  (await context({ logLevel: 'silent' })).serve({ servedir, host: '127.0.0.1', port: number });
const { port: open } = await (port ? listen(Number(port)) : listen(USUAL_PORT).catch(() => listen(0))).catch(
  ({ message }) => {
    console.error(message);
    process.exit(1);
  },
);
console.log(`http://127.0.0.1:${open}/`);
process.stdin
  .on('end', async () => {
    // Left to itself, the process of esbuild may outlive this one, with the port.
    await stop();
    process.exit(0);
  })
  .resume();
