import { usePage } from "../model/page";

/** The live regions that a screen reader listens to. */
export function Announcements() {
  const { announcer } = usePage();
  return (
    <>
      <div class="hidden" role="status" aria-live="polite">
        {announcer.polite.value}
      </div>
      <div class="hidden" role="alert" aria-live="assertive">
        {announcer.assertive.value}
      </div>
    </>
  );
}
