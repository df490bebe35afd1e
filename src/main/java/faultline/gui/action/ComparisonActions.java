package faultline.gui.action;

import faultline.engine.recording.RunEvent;
import faultline.engine.session.SessionFrame;
import faultline.gui.document.ComparisonController;
import faultline.gui.document.NamedReferenceRun;
import faultline.gui.document.RunComparison;
import faultline.gui.text.Messages;
import faultline.paint.scene.ReferenceOverlay;
import java.awt.event.KeyEvent;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.function.BiConsumer;
import java.util.function.Supplier;

/** The actions on the reference run, and the description of how it compares with the current run. */
public final class ComparisonActions {

    private final ComparisonController comparisonController;
    private final BiConsumer<Optional<ReferenceOverlay>, Optional<RunEvent.Diverged>> view;
    private final UiAction removeAction;
    private Optional<RunComparison> shownComparison = Optional.empty();

    /**
     * Creates the actions.
     *
     * @param comparisonController compares the runs
     * @param view shows the reference run and where the two runs first differ, each empty if there is none
     */
    public ComparisonActions(
            ComparisonController comparisonController,
            BiConsumer<Optional<ReferenceOverlay>, Optional<RunEvent.Diverged>> view) {
        this.comparisonController = comparisonController;
        this.view = view;
        removeAction = UiAction.of("removeGhost", comparisonController::removeReference);
        removeAction.setEnabled(false);
    }

    /** Adds the actions to a registry; {@code chooseFile} asks for the file of a reference run. */
    public void addTo(ActionRegistry actions, Supplier<Optional<Path>> chooseFile) {
        actions.add(UiAction.of("keepGhost", comparisonController::captureCurrentRun)
                .withAccelerator(Keystrokes.menuShortcut(KeyEvent.VK_G)));
        actions.add(UiAction.of("openGhost", () -> chooseFile.get().ifPresent(comparisonController::loadReference)));
        actions.add(removeAction);
    }

    /** Compares the newest frame and updates the view if the result has changed. */
    public void update(SessionFrame frame) {
        Optional<RunComparison> comparison = comparisonController.update(frame);
        removeAction.setEnabled(comparison.isPresent() || comparisonController.isLoading());
        if (!comparison.equals(shownComparison)) {
            shownComparison = comparison;
            view.accept(
                    comparison.map(ComparisonActions::createOverlay),
                    comparison.flatMap(ComparisonActions::divergenceEvent));
        }
    }

    private static Optional<RunEvent.Diverged> divergenceEvent(RunComparison comparison) {
        OptionalLong tick = comparison.divergence();
        return tick.isPresent()
                ? Optional.of(new RunEvent.Diverged(
                        tick.getAsLong(),
                        tick.getAsLong() * comparison.reference().dt()))
                : Optional.empty();
    }

    private static ReferenceOverlay createOverlay(RunComparison comparison) {
        NamedReferenceRun reference = comparison.reference();
        return new ReferenceOverlay(
                reference.run(),
                reference.dt(),
                captionLines(comparison),
                divergenceEvent(comparison).stream()
                        .map(event -> new ReferenceOverlay.Mark(
                                event.tick(), Messages.get("ghost.mark", secondsText(event.time()))))
                        .toList());
    }

    private static List<String> captionLines(RunComparison comparison) {
        NamedReferenceRun reference = comparison.reference();
        List<String> lines = new ArrayList<>();
        lines.add(Messages.get(
                "ghost.name", reference.name(), secondsText(reference.run().lastTick() * reference.dt())));
        lines.add(divergenceEvent(comparison)
                .map(event -> Messages.get("ghost.differs", secondsText(event.time())))
                .orElse(Messages.get("ghost.same")));
        if (comparison.seedDiffers()) {
            lines.add(Messages.get("ghost.seed", Long.toString(reference.seed())));
        }
        return lines;
    }

    private static String secondsText(double time) {
        return String.format(Locale.ROOT, "%.2f s", time);
    }
}
