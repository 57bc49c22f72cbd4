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

  const isReady = () => (location.hash.includes("project=") ? showsProject() : document.querySelector("main h1"));

  const showsProject = () =>
    document.querySelector(".blocklyBlockCanvas .blocklyDraggable") !== null &&
    (globalThis.learnblock?.views.world.value?.framesDrawn ?? 0) > 0 &&
    learnblock.context.running.scene.value !== null;

  /** Until the start page, or blocks and world, are there: ms since the navigation. */
  const ready = async () => {
    while (!isReady()) await nextFrame();
    return { ready: await painted() };
  };

  /** What has come over the wire, in bytes, and when the first of it was painted. */
  const transferred = () => {
    const came = [...performance.getEntriesByType("navigation"), ...performance.getEntriesByType("resource")];
    return {
      painted: performance.getEntriesByName("first-contentful-paint")[0]?.startTime ?? 0,
      bytes: came.reduce((sum, one) => sum + one.transferSize, 0),
      requests: came.length,
    };
  };

  const tasks = [];
  new PerformanceObserver((list) => tasks.push(...list.getEntries())).observe({ type: "longtask" });

  /** From now on, until each key is painted; typing must change the text. */
  const watchKeys = () => {
    tasks.length = measures.keys.length = 0;
    addEventListener(
      "keydown",
      async ({ timeStamp }) => {
        const end = await painted();
        measures.keys.push(end - timeStamp);
      },
      { capture: true },
    );
  };

  const longestTask = () => Math.max(0, ...tasks.map(({ duration }) => duration));

  /** Whether the program has as many turns, and they have arrived as blocks. */
  const hasTurns = (count) =>
    learnblock.context.program.settled &&
    JSON.stringify(learnblock.context.program.state.value.workspace).split('"lb_skill_turn"').length > count;

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
    const [began, before] = [await nextFrame(), learnblock.views.world.value.framesDrawn];
    let [now, count, gap] = [began, 0, 0];
    while (now - began < duration) {
      const next = await nextFrame();
      gap = Math.max(gap, next - now);
      now = next;
      count += 1;
    }
    const seconds = (now - began) / 1000;
    return { drawn: (learnblock.views.world.value.framesDrawn - before) / seconds, display: count / seconds, gap };
  };

  return { ready, transferred, paste, watch, frames, watchKeys, longestTask, hasTurns, keys: [], seen: null };
})();
