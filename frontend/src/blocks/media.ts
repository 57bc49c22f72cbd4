/** Where Blockly finds its pictures and sounds: in our own copy, never on the internet. */

// All of them, so that the build carries all; they land in one folder (see vite.config.ts).
const files = import.meta.glob<string>("../../node_modules/blockly/media/*", {
  eager: true,
  query: "?url&no-inline",
  import: "default",
});

const sprites = files["../../node_modules/blockly/media/sprites.svg"]!;

/** The folder's address, with a slash at its end. */
export const MEDIA = new URL(".", new URL(sprites, document.baseURI)).href;
