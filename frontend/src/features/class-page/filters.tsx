/** Over the tiles: how many pupils are in each state, which are shown, and in which order. */

import type { Signal } from "@preact/signals";

import { t } from "../../i18n";
import type { Seat } from "../../protocol/classroom";
import { Icon } from "../../ui/icons";
import { counts, ORDERS, type Order, STATE_ICONS, STATES, type State } from "./states";

interface Props {
  readonly seats: readonly Seat[];
  /** The state that is shown; null for all. */
  readonly filter: Signal<State | null>;
  readonly order: Signal<Order>;
  /** How many tiles would move if they were sorted now. */
  readonly changes: number;
  readonly sort: () => void;
  readonly openSide: () => void;
}

export function Filters({ seats, filter, order, changes, sort, openSide }: Props) {
  const found = counts(seats);
  const waiting = (found.get("help") ?? 0) + (found.get("stuck") ?? 0);
  return (
    <div class="wall-filters" data-wall-region>
      <div class="chips" role="group" aria-label={t("page-class-filters")}>
        <button type="button" class="chip" aria-pressed={!filter.value} onClick={() => (filter.value = null)}>
          {t("page-class-all")} <b>{seats.length}</b>
        </button>
        {STATES.map((state) => (
          <button
            key={state}
            type="button"
            class={`chip ${state}`}
            aria-pressed={filter.value === state}
            onClick={() => (filter.value = filter.value === state ? null : state)}
          >
            <Icon name={STATE_ICONS[state]} />
            {t(`page-class-filter-${state}`)} <b>{found.get(state) ?? 0}</b>
          </button>
        ))}
      </div>
      {changes > 0 && (
        <button type="button" class="chip changes" onClick={sort}>
          {t("page-class-changes", { count: changes })}
        </button>
      )}
      <label class="wall-order">
        <span class="hidden">{t("page-class-order")}</span>
        <select value={order.value} onChange={({ currentTarget }) => (order.value = currentTarget.value as Order)}>
          {ORDERS.map((one) => (
            <option key={one} value={one}>
              {t(`page-class-order-${one}`)}
            </option>
          ))}
        </select>
      </label>
      <button type="button" class="button bordered wall-side-button" aria-haspopup="dialog" onClick={openSide}>
        <Icon name="hand" />
        {t("page-class-waiting-for-you")} <b>{waiting}</b>
      </button>
    </div>
  );
}
