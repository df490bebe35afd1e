package faultline.gui.window;

import faultline.engine.session.SessionFrame;
import faultline.engine.recording.RunEvent;
import faultline.gui.action.ActionRegistry;
import faultline.gui.action.Keystrokes;
import faultline.gui.action.UiAction;
import faultline.gui.document.ComparisonController;
import faultline.gui.document.NamedReferenceRun;
import faultline.gui.document.RunComparison;
import faultline.gui.text.Messages;
import java.awt.event.KeyEvent;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.function.Supplier;

/** The actions on the earlier run that is shown beside this one, and how the two compare, in words. */
final class ComparisonActions {

    private final ComparisonController comparisonController;
    private final MainPanel mainPanel;
    private final UiAction removeAction;
    private Optional<RunComparison> shownComparison = Optional.empty();

    ComparisonActions(ComparisonController desk, MainPanel area) {
        this.comparisonController = desk;
        this.mainPanel = area;
        removeAction = UiAction.of("removeGhost", desk::removeReference);
        removeAction.setEnabled(false);
    }

    void addTo(ActionRegistry actions, Supplier<Optional<Path>> file) {
        actions.add(UiAction.of("keepGhost", comparisonController::captureCurrentRun)
                .withAccelerator(Keystrokes.menuShortcut(KeyEvent.VK_G)));
        actions.add(UiAction.of("openGhost", () -> file.get().ifPresent(comparisonController::loadReference)));
        actions.add(removeAction);
    }

    /** Compares the newest frame, and shows what is new. */
    void update(SessionFrame frame) {
        Optional<RunComparison> now = comparisonController.update(frame);
        removeAction.setEnabled(now.isPresent() || comparisonController.isLoading());
        if (!now.equals(shownComparison)) {
            shownComparison = now;
            mainPanel.setReferenceRun(
                    now.map(ComparisonActions::createOverlay), now.flatMap(ComparisonActions::divergenceEvent));
        }
    }

    private static Optional<RunEvent.Diverged> divergenceEvent(RunComparison haunting) {
        OptionalLong tick = haunting.divergence();
        return tick.isPresent()
                ? Optional.of(new RunEvent.Diverged(
                        tick.getAsLong(),
                        tick.getAsLong() * haunting.reference().dt()))
                : Optional.empty();
    }

    private static faultline.paint.scene.ReferenceOverlay createOverlay(RunComparison haunting) {
        NamedReferenceRun ghost = haunting.reference();
        return new faultline.paint.scene.ReferenceOverlay(
                ghost.run(),
                ghost.dt(),
                haunting.divergence(),
                caption(haunting),
                divergenceEvent(haunting)
                        .map(event -> Messages.get("ghost.mark", secondsText(event.time())))
                        .orElse(""));
    }

    private static List<String> caption(RunComparison haunting) {
        NamedReferenceRun ghost = haunting.reference();
        List<String> lines = new ArrayList<>();
        lines.add(
                Messages.get("ghost.name", ghost.name(), secondsText(ghost.run().lastTick() * ghost.dt())));
        lines.add(divergenceEvent(haunting)
                .map(event -> Messages.get("ghost.differs", secondsText(event.time())))
                .orElse(Messages.get("ghost.same")));
        if (haunting.seedDiffers()) {
            lines.add(Messages.get("ghost.seed", Long.toString(ghost.seed())));
        }
        return lines;
    }

    private static String secondsText(double time) {
        return String.format(Locale.ROOT, "%.2f s", time);
    }
}
