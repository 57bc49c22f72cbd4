/** The world of another pupil, in which the guest's program drives a robot. */

import { t } from "../i18n";
import { ConnectionBanner } from "./banner";
import { EyeMenu } from "./world/eye-menu";
import { WorldPlace } from "./world/world-pane";
import "../ui/fonts.css";
import "../ui/theme.css";
import "../ui/controls.css";
import "./layout.css";
import "./guest-page.css";

export function GuestPage() {
  return (
    <main class="guest">
      <ConnectionBanner />
      <section class="region world-pane" aria-label={t("page-shell-world")}>
        <WorldPlace isGuests>
          <EyeMenu />
        </WorldPlace>
      </section>
    </main>
  );
}
