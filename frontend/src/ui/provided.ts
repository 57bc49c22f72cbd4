import { createContext } from "preact";
import { useContext } from "preact/hooks";

/**
 * A value for all components below a provider, and the hook that gives it to them.
 *
 * @param name appears in the error if there is no provider.
 */
export function provided<T>(name: string) {
  const context = createContext<T | null>(null);
  const use = (): T => {
    const value = useContext(context);
    if (value === null) throw new Error(`${name} is used outside its provider`);
    return value;
  };
  return [context.Provider, use] as const;
}
