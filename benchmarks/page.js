/** What `page.py` has the page measure; put into it before all else. */

globalThis.measures = (() => {
  const stamps = { sent: 0, answered: 0 };

  // Sees when an edit leaves and when its answer comes.
  globalThis.WebSocket = class extends WebSocket {
    constructor(...given) {
      super(...given);
      this.addEventListener("message", ({ data }) => {
        if (typeof data === "string" && data.startsWith('{"kind":"Document"')) stamps.answered = performance.now();
      });
    }

    send(data) {
      if (data.startsWith('{"kind":"Edit')) stamps.sent = performance.now();
      super.send(data);
    }
  };

  /** Until what is there now has been painted. */
  const painted = () =>
    new Promise((resolve) => {
      requestAnimationFrame(() => {
        const { port1, port2 } = new MessageChannel();
        port1.onmessage = () => resolve(performance.now());
        port2.postMessage(null);
      });
    });

  const nextFrame = () => new Promise(requestAnimationFrame);

  const isReady = () =>
    document.querySelector(".blocklyBlockCanvas .blocklyDraggable") !== null &&
    (globalThis.learnblock?.views.world?.framesDrawn ?? 0) > 0 &&
    learnblock.context.running.scene.value !== null;

  /** Until blocks and world are there: ms since the navigation, and what came over the wire. */
  const ready = async () => {
    while (!isReady()) await nextFrame();
    const time = performance.now();
    const came = [...performance.getEntriesByType("navigation"), ...performance.getEntriesByType("resource")];
    return {
      ready: time,
      painted: performance.getEntriesByName("first-contentful-paint")[0]?.startTime ?? 0,
      bytes: came.reduce((sum, one) => sum + one.transferSize, 0),
      requests: came.length,
    };
  };

  /** As from the clipboard; to type it would take the browser half a minute. */
  const paste = (text) => {
    const clipboardData = new DataTransfer();
    clipboardData.setData("text/plain", text);
    document.activeElement.dispatchEvent(new ClipboardEvent("paste", { clipboardData, bubbles: true, cancelable: true }));
  };

  const shows = ([selector, text]) => {
    const shown = document.querySelector(selector)?.textContent ?? "";
    return shown.slice(0, 2000).replaceAll("\u00a0", " ").includes(text);
  };

  /** From the next key on, until every `[selector, text]` of `wanted` is seen. */
  const watch = (wanted) => {
    const figures = {};
    addEventListener("keydown", (event) => (figures.pressed = event.timeStamp), { capture: true, once: true });
    measures.seen = null;
    const observer = new MutationObserver(async () => {
      if (!wanted.every(shows)) return;
      observer.disconnect();
      figures.shown = performance.now();
      figures.painted = await painted();
      measures.seen = { ...figures, ...stamps };
    });
    observer.observe(document.body, { subtree: true, childList: true, characterData: true });
  };

  /** Pictures a second, of the world and of the display, and the longest time without one. */
  const frames = async (duration) => {
    const [began, before] = [await nextFrame(), learnblock.views.world.framesDrawn];
    let [now, count, gap] = [began, 0, 0];
    while (now - began < duration) {
      const next = await nextFrame();
      gap = Math.max(gap, next - now);
      now = next;
      count += 1;
    }
    const seconds = (now - began) / 1000;
    return { drawn: (learnblock.views.world.framesDrawn - before) / seconds, display: count / seconds, gap };
  };

  return { ready, paste, watch, frames, seen: null };
})();
