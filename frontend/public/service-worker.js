// Makes the page an app that can be installed. It answers only when the server does not: with a page
// that says so. Everything else comes from the server, whose files the browser keeps anyway.

const CACHE = "learnblock";
const ASLEEP = "asleep.html";

self.addEventListener("install", (event) => {
  event.waitUntil(caches.open(CACHE).then((cache) => cache.add(new Request(ASLEEP, { cache: "reload" }))));
  self.skipWaiting();
});

self.addEventListener("fetch", (event) => {
  if (event.request.mode !== "navigate") return;
  event.respondWith(fetch(event.request).catch(() => caches.match(ASLEEP)));
});
