/** Where the program scrolls to while it runs. */

interface Area {
  readonly left: number;
  readonly right: number;
}

interface View {
  readonly left: number;
  readonly width: number;
}

/**
 * The sides to bring into sight for a block that runs: a program must not move sideways, so a block of which something
 * is in the view asks for no more than the view's middle.
 */
export function sidesToFollow({ left, right }: Area, view: View): Area {
  const isBeside = right <= view.left || left >= view.left + view.width;
  const middle = view.left + view.width / 2;
  return isBeside ? { left, right } : { left: middle, right: middle };
}
