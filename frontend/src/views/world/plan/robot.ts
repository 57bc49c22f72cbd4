/** A robot in a plan, from above: an arrow that points where it faces. */

/** The outline of an arrow with half of its length in mm. */
export function arrow(half: number): string {
  return `M ${half} 0 L ${-half} ${half * 0.7} L ${-half * 0.6} 0 L ${-half} ${-half * 0.7} Z`;
}
