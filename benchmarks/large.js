/** What `large.py` has the page measure; put into it before all else. */

globalThis.large = (() => {
  const tasks = [];
  new PerformanceObserver((list) => {
    for (const { startTime, duration } of list.getEntries()) tasks.push({ startTime, duration });
  }).observe({ type: "longtask", buffered: true });

  const pause = () => new Promise((resolve) => setTimeout(resolve, 50));
  const texts = (view) => document.querySelector(`[data-region=${view}] .cm-content`)?.textContent ?? "";
  const reads = (view, words) => texts(view).replaceAll("\u00a0", " ").includes(words);
  // Cheap: it is asked twenty times a second, in a page that may have 100,000 elements.
  const isBuilt = () =>
    document.getElementsByClassName("blocks-loading").length === 0 &&
    (document.getElementsByClassName("blocklyDraggable")[0] ?? null) !== null &&
    learnblock.context.program.state.value.workspace.stacks.length > 0;

  /** Until each of these conditions holds: ms since `began`. */
  const times = async (began, conditions) => {
    const found = {};
    while (Object.keys(found).length < Object.keys(conditions).length) {
      await pause();
      for (const [name, holds] of Object.entries(conditions)) {
        if (!(name in found) && holds()) found[name] = performance.now() - began;
      }
    }
    return found;
  };

  /** Until the page has done nothing long for a second: the longest tasks since `began`. */
  const rest = async (began) => {
    let last = performance.now();
    while (performance.now() - last < 1000) {
      await pause();
      const end = Math.max(0, ...tasks.map(({ startTime, duration }) => startTime + duration));
      last = Math.max(last, end);
    }
    const own = tasks.filter(({ startTime }) => startTime >= began).map(({ duration }) => duration);
    return own.sort((one, other) => other - one);
  };

  /** Until `conditions` hold and the page rests. */
  const measure = async (began, conditions) => {
    const took = await times(began, conditions);
    return { took, tasks: await rest(began) };
  };

  /** From the navigation until all views show the program. */
  const opening = () =>
    measure(0, {
      blocktext: () => reads("blocktext", "function."),
      blocks: isBuilt,
    });

  /** From an act until Block-Text and blocks show these words. */
  const edited = (words) => {
    const began = performance.now();
    large.seen = null;
    void measure(began, {
      blocktext: () => reads("blocktext", words),
      blocks: () =>
        isBuilt() && learnblock.context.program.settled && shows(words)(document.querySelector(large.number)),
    }).then((found) => (large.seen = found));
  };
  const shows = (words) => (block) => words.includes(`(${block?.textContent})`);

  return { opening, edited, rest, now: () => performance.now(), number: "", seen: null };
})();
