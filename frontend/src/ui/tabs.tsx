/** Tabs over their panels. */

import type { ComponentChildren } from "preact";

import "./tabs.css";

export interface Tab<Name extends string> {
  readonly name: Name;
  readonly text: string;
  /** A number on the tab, such as the number of problems; 0 is not shown. */
  readonly count?: number;
  /** Whether the number counts something serious. */
  readonly serious?: boolean;
  readonly panel: ComponentChildren;
}

interface Props<Name extends string> {
  readonly label: string;
  readonly tabs: readonly Tab<Name>[];
  readonly selected: Name;
  readonly select: (name: Name) => void;
}

/** All panels stay in the page, so a hidden one keeps updating. */
export function Tabs<Name extends string>({ label, tabs, selected, select }: Props<Name>) {
  return (
    <>
      <div class="tabs" role="tablist" aria-label={label} onKeyDown={navigateTabs}>
        {tabs.map((tab) => (
          <button
            type="button"
            key={tab.name}
            role="tab"
            id={`tab-${tab.name}`}
            aria-controls={`panel-${tab.name}`}
            aria-selected={tab.name === selected}
            tabIndex={tab.name === selected ? 0 : -1}
            onClick={() => select(tab.name)}
          >
            {tab.text} {!!tab.count && <span class={tab.serious ? "count serious" : "count"}>{tab.count}</span>}
          </button>
        ))}
      </div>
      {tabs.map((tab) => (
        <div
          key={tab.name}
          class="tab-panel"
          role="tabpanel"
          id={`panel-${tab.name}`}
          aria-labelledby={`tab-${tab.name}`}
          hidden={tab.name !== selected}
          // biome-ignore lint/a11y/noNoninteractiveTabindex: the keyboard scrolls it
          tabIndex={0}
        >
          {tab.panel}
        </div>
      ))}
    </>
  );
}

/** Move among the tabs of a list by the usual keys. */
export function navigateTabs(event: KeyboardEvent): void {
  const tabs = [...(event.currentTarget as HTMLElement).querySelectorAll<HTMLElement>("[role=tab]")];
  const at = tabs.indexOf(event.target as HTMLElement);
  const targets: Record<string, number> = { ArrowRight: at + 1, ArrowLeft: at - 1, Home: 0, End: tabs.length - 1 };
  const target = targets[event.key];
  if (target === undefined) return;
  event.preventDefault();
  const tab = tabs.at(target % tabs.length);
  tab?.focus();
  tab?.click();
}
