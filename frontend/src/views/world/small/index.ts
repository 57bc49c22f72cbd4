/** Small pictures of worlds in 3D, for many at once: drawn once, then only a way and a robot are painted over them. */

export { paint } from "./paint";
export { Plates } from "./plates";
export { drawPortrait } from "./portrait";
