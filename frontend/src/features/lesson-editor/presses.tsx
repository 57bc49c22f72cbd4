/** The keys that a step presses when its checks run without a player, at times of the robot. */

import { t } from "../../i18n";
import { usePage } from "../../model/page";
import { choice } from "../../ui/form/choice";
import { FormField } from "../../ui/form/field";
import { Parts } from "../../ui/form/parts";
import { describeKeys, type Key } from "../../views/world/held-keys";
import type { KeyPressContent, StepContent } from "../lessons/lesson-edit";

const KEYS = ["up", "down", "left", "right", "space", "enter", ..."abcdefghijklmnopqrstuvwxyz0123456789"] as const;
const MOST = 100;
/** What a press has without values of its own, and what is possible, as in the file of a lesson. */
const TIMES = {
  at: { initial: 0, shape: { kind: "number", least: 0, most: 3600 } },
  seconds: { initial: 0.2, shape: { kind: "number", least: 0.05, most: 600 } },
  times: { initial: 1, shape: { kind: "number", least: 1, most: 100, step: 1 } },
  every: { initial: 1, shape: { kind: "number", least: 0.1, most: 60 } },
} as const;
const NAMES = Object.keys(TIMES) as (keyof typeof TIMES)[];

export function Presses({ step, index }: { step: StepContent; index: number }) {
  const making = usePage().lessonMaking;
  const { keys = [] } = step;
  return (
    <section class="maker-group">
      <h3>{t("page-maker-keys")}</h3>
      <p class="dim">{t("page-maker-keys-help")}</p>
      <Parts
        values={keys}
        take={(all) => making.editStep(index, { keys: all.length > 0 ? all : undefined })}
        title={(number) => t("page-maker-press", { number })}
        add={t("page-maker-add-press")}
        fresh={() => next(keys)}
        most={MOST}
      >
        {(press, take, at) => <Press press={press} path={["step", index, "keys", at]} take={take} />}
      </Parts>
    </section>
  );
}

/** The same key again, a second after the last one. */
function next(keys: readonly KeyPressContent[]): KeyPressContent {
  const last = keys.at(-1);
  if (!last) return { key: "up", at: 1 };
  return { key: last.key, at: last.at + (last.times ?? TIMES.times.initial) * (last.every ?? TIMES.every.initial) };
}

interface PressProps {
  readonly press: KeyPressContent;
  readonly path: readonly (string | number)[];
  readonly take: (press: KeyPressContent) => void;
}

function Press({ press, path, take }: PressProps) {
  return (
    <div class="maker-row">
      <FormField
        label={t("page-maker-press-key")}
        path={[...path, "key"]}
        value={press.key}
        {...choice(KEYS.map((key) => [key, inWords(key)] as const))}
        take={(key) => take({ ...press, key })}
      />
      {NAMES.map((name) => (
        <FormField
          key={name}
          label={t(`page-maker-press-${name}`)}
          path={[...path, name]}
          shape={TIMES[name].shape}
          value={press[name] ?? TIMES[name].initial}
          take={(value) => take({ ...press, [name]: value ?? TIMES[name].initial })}
        />
      ))}
    </div>
  );
}

function inWords(key: string): string {
  return describeKeys([key as Key]);
}
