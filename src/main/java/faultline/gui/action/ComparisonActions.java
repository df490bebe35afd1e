package faultline.gui.action;

import faultline.engine.SimulationSetup;
import faultline.engine.metrics.RunMeasures;
import faultline.engine.recording.RunEvent;
import faultline.engine.session.ReferenceRun;
import faultline.engine.session.SessionFrame;
import faultline.gui.document.ComparisonController;
import faultline.gui.document.RunComparison;
import faultline.gui.text.ContactText;
import faultline.gui.text.ExpectationText;
import faultline.gui.text.Messages;
import faultline.gui.text.NumberText;
import faultline.gui.text.RefusalText;
import faultline.paint.scene.ReferenceOverlay;
import java.awt.event.KeyEvent;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.function.Supplier;

/** The actions on the reference run, and the description of how it compares with the current run. */
public final class ComparisonActions {

    private final ComparisonController controller;
    private final BiConsumer<ReferenceOverlay, RunEvent.Diverged> view;
    private final UiAction keepAction;
    private final UiAction removeAction;
    private final GhostNote progressNote;
    /** Null if there is no reference run. */
    private RunComparison shownComparison;

    /**
     * Creates the actions. {@code view} shows the reference run and where the two runs first differ, each null if there
     * is none.
     */
    public ComparisonActions(
            ComparisonController controller, BiConsumer<ReferenceOverlay, RunEvent.Diverged> view, Notes notes) {
        this.controller = controller;
        this.view = view;
        keepAction = UiAction.of("keepGhost", controller::captureCurrentRun)
                .withAccelerator(Keystrokes.menuShortcut(KeyEvent.VK_G));
        keepAction.setEnabled(false);
        removeAction = UiAction.of("removeGhost", this::removeOrCancel);
        removeAction.setEnabled(false);
        progressNote = new GhostNote(controller, notes, System::nanoTime);
    }

    private void removeOrCancel() {
        if (controller.pending().isPresent()) {
            controller.cancelPending();
        } else {
            controller.removeReference();
        }
    }

    /** Adds the actions to a registry; {@code chooseFile} asks for the file of a reference run. */
    public void addTo(ActionRegistry actions, Supplier<Optional<Path>> chooseFile) {
        actions.add(keepAction);
        actions.add(UiAction.of("openGhost", () -> chooseFile.get().ifPresent(controller::loadReference)));
        actions.add(removeAction);
    }

    /** Lets the next update show the comparison again, in the current language. */
    public void updateTexts() {
        shownComparison = null;
    }

    /** Compares the newest frame and updates the view if the result has changed, and the note about the progress. */
    public void update(SessionFrame frame) {
        progressNote.update();
        RunComparison comparison = controller.update(frame).orElse(null);
        keepAction.setEnabled(controller.canCapture());
        removeAction.setEnabled(comparison != null || controller.pending().isPresent());
        if (comparison != shownComparison) {
            shownComparison = comparison;
            if (comparison == null) {
                view.accept(null, null);
            } else {
                view.accept(createOverlay(comparison), comparison.divergenceOrNull());
            }
        }
    }

    static ReferenceOverlay createOverlay(RunComparison comparison) {
        ReferenceRun run = comparison.run();
        SimulationSetup setup = run.setup();
        Optional<String> divergence = comparison.divergence().map(event -> NumberText.format("%.2f s", event.time()));
        List<String> caption = new ArrayList<>();
        caption.add(Messages.get(
                "ghost.name", comparison.name(), NumberText.format("%.2f s", run.lastTick() * setup.dt())));
        caption.add(divergence
                .map(time -> Messages.get("ghost.differs", time))
                .orElseGet(() -> Messages.get(comparison.whole() ? "ghost.sameToEnd" : "ghost.same")));
        run.collision().map(ContactText::collision).ifPresent(caption::add);
        measuresText(run.measures()).ifPresent(caption::add);
        if (comparison.seedDiffers()) {
            caption.add(Messages.get("ghost.seed", Long.toString(setup.seed())));
        }
        refusalText(run).ifPresent(caption::add);
        List<ReferenceOverlay.Mark> marks = comparison.divergence().stream()
                .map(event -> new ReferenceOverlay.Mark(
                        event.tick(), Messages.get("ghost.mark", NumberText.format("%.2f s", event.time()))))
                .toList();
        return new ReferenceOverlay(run, caption, marks);
    }

    /** Describes the first refused command of a run, with the number of further ones; empty if there was none. */
    private static Optional<String> refusalText(ReferenceRun run) {
        return run.firstRefusal()
                .map(first -> Messages.get(
                        run.refusalCount() == 1 ? "ghost.refused" : "ghost.refusedMore",
                        NumberText.format("%.2f s", run.setup().timeOf(first.tick())),
                        RefusalText.format(first.reason()),
                        Integer.toString(run.refusalCount() - 1)));
    }

    /** Describes the measures of a run at its end; empty if it has followed no wall. */
    private static Optional<String> measuresText(RunMeasures measures) {
        return measures.equals(RunMeasures.NONE)
                ? Optional.empty()
                : Optional.of(Messages.get(
                        "ghost.measures",
                        ExpectationText.percent(measures.coverage()),
                        NumberText.formatOrDash("%.2f", measures.laps()),
                        ExpectationText.millimetres(measures.distanceRms())));
    }
}
