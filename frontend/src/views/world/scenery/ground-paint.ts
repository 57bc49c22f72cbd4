/** The paint of the ground: one colour that fades into the horizon, cheaper to draw than a material with fog. */

import { type Fog, ShaderMaterial } from "three";
import { raw } from "./floor-paint";

const VERTEX = /* glsl */ `
  varying float vDepth;
  void main() {
    vec4 place = modelViewMatrix * vec4(position, 1.0);
    vDepth = -place.z;
    gl_Position = projectionMatrix * place;
  }
`;

/** Colours are mixed as squares, which is close to mixing light, and leave as they are on the screen. */
const FRAGMENT = /* glsl */ `
  uniform vec3 near;
  uniform vec3 far;
  uniform vec2 fade;
  varying float vDepth;
  void main() {
    float part = smoothstep(fade.x, fade.y, vDepth);
    gl_FragColor = vec4(sqrt(mix(near * near, far * far, part)), 1.0);
  }
`;

/** @param horizon the colour that the ground fades into. */
export function groundPaint(ground: string, horizon: string, { near, far }: Fog): ShaderMaterial {
  const uniforms = {
    near: { value: raw(ground) },
    far: { value: raw(horizon) },
    fade: { value: [near, far] },
  };
  return new ShaderMaterial({ uniforms, vertexShader: VERTEX, fragmentShader: FRAGMENT });
}
