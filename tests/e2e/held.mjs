/** What a page holds. */

/** Memory that the page and its workers hold after a garbage collection. @param {import('./driver.mjs').Tab} tab */
export async function held(tab) {
  const session = await tab.page.createCDPSession();
  const heaps = [session, ...tab.page.workers().map((worker) => worker.client)];
  let bytes = 0;
  for (const heap of heaps) {
    await heap.send('HeapProfiler.enable');
    // Observers and finalisers release objects a few frames later.
    for (let round = 0; round < 4; round += 1) {
      await heap.send('HeapProfiler.collectGarbage');
      await tab.frames(8);
    }
    const { usedSize, backingStorageSize } = await heap.send('Runtime.getHeapUsage');
    bytes += usedSize + backingStorageSize;
  }
  const { nodes, jsEventListeners } = await session.send('Memory.getDOMCounters');
  await session.detach();
  return { bytes, nodes, jsEventListeners, ...(await tab.living()) };
}
