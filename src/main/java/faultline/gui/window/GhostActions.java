package faultline.gui.window;

import faultline.engine.Frame;
import faultline.engine.record.RunEvent;
import faultline.gui.action.Keystrokes;
import faultline.gui.action.UiAction;
import faultline.gui.document.Ghost;
import faultline.gui.document.GhostDesk;
import faultline.gui.document.Haunting;
import faultline.gui.text.Texts;
import java.awt.event.KeyEvent;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.function.Supplier;

/** The actions on the earlier run that is shown beside this one, and how the two compare, in words. */
final class GhostActions {

    private final GhostDesk desk;
    private final WorkArea area;
    private final UiAction remove;
    private Optional<Haunting> shown = Optional.empty();

    GhostActions(GhostDesk desk, WorkArea area) {
        this.desk = desk;
        this.area = area;
        remove = UiAction.of("removeGhost", desk::remove);
        remove.setEnabled(false);
    }

    void addTo(UiActions actions, Supplier<Optional<Path>> file) {
        actions.add(UiAction.of("keepGhost", desk::keep).on(Keystrokes.menu(KeyEvent.VK_G)));
        actions.add(UiAction.of("openGhost", () -> file.get().ifPresent(desk::open)));
        actions.add(remove);
    }

    /** Compares the newest frame, and shows what is new. */
    void show(Frame frame) {
        Optional<Haunting> now = desk.see(frame);
        remove.setEnabled(now.isPresent() || desk.isUnderWay());
        if (!now.equals(shown)) {
            shown = now;
            area.haunt(now.map(GhostActions::painted), now.flatMap(GhostActions::event));
        }
    }

    private static Optional<RunEvent.Diverged> event(Haunting haunting) {
        OptionalLong tick = haunting.divergence();
        return tick.isPresent() ? Optional.of(new RunEvent.Diverged(tick.getAsLong(), tick.getAsLong() * haunting.ghost().dt())) : Optional.empty();
    }

    private static faultline.paint.Ghost painted(Haunting haunting) {
        Ghost ghost = haunting.ghost();
        return new faultline.paint.Ghost(ghost.run(), ghost.dt(), haunting.divergence(), caption(haunting),
                event(haunting).map(event -> Texts.text("ghost.mark", seconds(event.time()))).orElse(""));
    }

    private static List<String> caption(Haunting haunting) {
        Ghost ghost = haunting.ghost();
        List<String> lines = new ArrayList<>();
        lines.add(Texts.text("ghost.name", ghost.name(), seconds(ghost.run().lastTick() * ghost.dt())));
        lines.add(event(haunting).map(event -> Texts.text("ghost.differs", seconds(event.time()))).orElse(Texts.text("ghost.same")));
        if (haunting.otherSeed()) {
            lines.add(Texts.text("ghost.seed", Long.toString(ghost.seed())));
        }
        return lines;
    }

    private static String seconds(double time) {
        return String.format(Locale.ROOT, "%.2f s", time);
    }
}
