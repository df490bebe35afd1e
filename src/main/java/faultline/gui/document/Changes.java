package faultline.gui.document;

import faultline.scenario.Scenario;
import java.awt.EventQueue;
import java.util.Optional;

/** Finds out, without waiting, what commands to the run have made of the scenario: the window's mark of unsaved changes. */
final class Changes {

    private final Bench bench;
    private boolean stale;
    private boolean asking;

    Changes(Bench bench) {
        this.bench = bench;
    }

    /** Something may have changed the scenario since the last look. */
    void suspect() {
        stale = true;
    }

    /** Asks the run, if there is reason to. */
    void look() {
        if (stale && !asking) {
            bench.work().ifPresent(this::ask);
        }
    }

    private void ask(Work now) {
        stale = false;
        asking = true;
        now.session().wholeJournal().thenApplyAsync(now.document()::after)
                .whenComplete((edited, closed) -> EventQueue.invokeLater(() -> answered(now, Optional.ofNullable(edited))));
    }

    private void answered(Work asked, Optional<Scenario> edited) {
        asking = false;
        boolean changedBefore = bench.isChanged();
        edited.ifPresent(scenario -> bench.change(asked, document -> document.withEdited(scenario)));
        if (bench.isChanged() != changedBefore) {
            bench.listener().renamed();
        }
    }
}
