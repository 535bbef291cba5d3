/**
 * Watches the page from outside: how long each stage of a frame takes, and when it happened.
 *
 * The studio itself carries no stopwatch. What the page uses (workers, frames, listeners) is wrapped before
 * it starts; times are milliseconds since 1970, so that page and worker read the same clock.
 */

/** Runs in the page before anything else. */
export function watchPage() {
  const clock = () => performance.timeOrigin + performance.now();
  const records = { pointer: [], asked: [], came: [], applied: [], render: [], opened: [] };
  globalThis.bench = records;
  const opening = new MutationObserver(() => {
    if (document.querySelector(".studio[data-ready]")) records.opened.push(performance.now());
    if (records.opened.length > 0) opening.disconnect();
  });
  opening.observe(document, { subtree: true, childList: true, attributes: true });
  const span = (list, act) => {
    const from = clock();
    try {
      return act();
    } finally {
      list.push([from, clock()]);
    }
  };

  const listen = EventTarget.prototype.addEventListener;
  EventTarget.prototype.addEventListener = function (type, listener, options) {
    if (type !== "pointermove" || typeof listener !== "function") return listen.call(this, type, listener, options);
    return listen.call(this, type, (event) => span(records.pointer, () => listener.call(this, event)), options);
  };

  const next = globalThis.requestAnimationFrame.bind(globalThis);
  globalThis.requestAnimationFrame = (draw) => next((time) => span(records.render, () => draw(time)));

  // What follows an answer runs in promises after its handler: it is over when the next task begins.
  const { port1, port2 } = new MessageChannel();
  port1.onmessage = ({ data }) => records.applied.push([data, clock()]);
  const Plain = globalThis.Worker;
  globalThis.Worker = class extends Plain {
    postMessage(message, transfer) {
      if (message.method === "movePole") span(records.asked, () => super.postMessage(message, transfer));
      else super.postMessage(message, transfer);
    }
    set onmessage(handler) {
      super.onmessage = (event) => {
        const from = clock();
        records.came.push(from);
        port2.postMessage(from);
        handler(event);
      };
    }
  };
}

/** Runs in the worker once it has started. */
export function watchWorker() {
  const clock = () => performance.timeOrigin + performance.now();
  const records = [];
  self.bench = records;
  const [answer, post] = [self.onmessage, self.postMessage.bind(self)];
  self.onmessage = (event) => {
    records.push({ method: event.data.method, from: clock(), bytes: 0 });
    return answer.call(self, event);
  };
  self.postMessage = (message, options) => {
    const record = records.at(-1);
    record.computed = clock();
    for (const buffer of options?.transfer ?? []) record.bytes += buffer.byteLength;
    post(message, options);
    record.posted = clock();
  };
}
