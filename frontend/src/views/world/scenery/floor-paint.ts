/** The paint of the floor: the same light everywhere, so it needs none but shadows, and is cheap to draw. */

import { Color, LinearSRGBColorSpace, ShaderMaterial, type Texture, UniformsLib, UniformsUtils, Vector4 } from "three";

const VERTEX = /* glsl */ `
  #include <common>
  #include <shadowmap_pars_vertex>
  varying vec2 vPlace;
  void main() {
    vPlace = uv;
    #include <beginnormal_vertex>
    #include <defaultnormal_vertex>
    #include <begin_vertex>
    #include <project_vertex>
    #include <worldpos_vertex>
    #include <shadowmap_vertex>
  }
`;

/**
 * Squares, thin lines and bold lines, each averaged over the pixel. Software draws it faster than a texture,
 * and it stays sharp near the camera. Places are in squares.
 */
const SQUARES = /* glsl */ `
  uniform vec3 even;
  uniform vec3 odd;
  uniform vec4 thin;
  uniform vec4 bold;
  float lines(vec2 place, vec2 pixel, float width) {
    vec2 away = abs(fract(place - 0.5) - 0.5);
    vec2 part = min(away + 0.5 * pixel, width) - max(away - 0.5 * pixel, -width);
    vec2 covered = clamp(part / pixel, 0.0, 1.0);
    return max(covered.x, covered.y);
  }
  vec3 paint(vec2 place) {
    vec2 pixel = fwidth(place) + 1e-4;
    vec2 low = abs(fract((place - 0.5 * pixel) * 0.5) - 0.5);
    vec2 high = abs(fract((place + 0.5 * pixel) * 0.5) - 0.5);
    vec2 side = 2.0 * (low - high) / pixel;
    vec3 color = mix(even, odd, 0.5 - 0.5 * side.x * side.y);
    color = mix(color, thin.rgb, thin.a * lines(place, pixel, 0.015));
    return mix(color, bold.rgb, bold.a * lines(place / 5.0, pixel / 5.0, 0.005));
  }
`;

const PICTURE = /* glsl */ `
  uniform sampler2D map;
  vec3 paint(vec2 place) {
    return texture2D(map, place).rgb;
  }
`;

/** One comparison with the map of shadows, smoothed by the graphics card, instead of the five of other materials. */
const FRAGMENT = /* glsl */ `
  #include <common>
  #include <packing>
  #include <shadowmap_pars_fragment>
  uniform vec3 shade;
  varying vec2 vPlace;
  PAINT
  void main() {
    vec3 color = paint(vPlace);
    #if defined(USE_SHADOWMAP) && defined(SHADOWMAP_TYPE_PCF) && NUM_DIR_LIGHT_SHADOWS > 0
      vec4 place = vDirectionalShadowCoord[0];
      color *= mix(shade, vec3(1.0), texture(directionalShadowMap[0], place.xyz / place.w));
    #endif
    gl_FragColor = vec4(color, 1.0);
  }
`;

/** The colours of a floor, in the notation of style sheets; lines have an opacity. */
export interface Squares {
  readonly even: string;
  readonly odd: string;
  readonly thin: Line;
  readonly bold: Line;
}

export interface Line {
  readonly colour: string;
  readonly opacity: number;
}

/** @param shade the colour of shadows on white. */
export function squaresPaint({ even, odd, thin, bold }: Squares, shade: string): ShaderMaterial {
  const line = ({ colour, opacity }: Line) => new Vector4(...raw(colour).toArray(), opacity);
  const uniforms = {
    even: { value: raw(even) },
    odd: { value: raw(odd) },
    thin: { value: line(thin) },
    bold: { value: line(bold) },
  };
  return material(SQUARES, shade, uniforms);
}

/** @param map must have no colour space: it is drawn without conversion. */
export function picturePaint(map: Texture, shade: string): ShaderMaterial {
  return material(PICTURE, shade, { map: { value: map } });
}

function material(paint: string, shade: string, own: Record<string, { value: unknown }>): ShaderMaterial {
  const uniforms = { ...UniformsUtils.clone(UniformsLib.lights), ...own, shade: { value: raw(shade) } };
  const fragmentShader = FRAGMENT.replace("PAINT", paint);
  return new ShaderMaterial({ uniforms, vertexShader: VERTEX, fragmentShader, lights: true });
}

/** A colour as it is on the screen. */
export function raw(colour: string): Color {
  return new Color().setStyle(colour, LinearSRGBColorSpace);
}
