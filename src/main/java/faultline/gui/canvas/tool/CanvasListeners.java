package faultline.gui.canvas.tool;

import faultline.geometry.Pose;
import faultline.world.Snapshot;
import java.awt.Point;
import java.util.ArrayList;
import java.util.List;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.function.Predicate;

/** The listeners of a canvas. */
public final class CanvasListeners {

    private final List<BiConsumer<String, Predicate<Snapshot>>> notes = new ArrayList<>();
    private final List<Consumer<Point>> menus = new ArrayList<>();
    private final List<Consumer<Pose>> starts = new ArrayList<>();

    /**
     * Adds a listener for sentences that say why something was not done, each with whether it still holds in a world.
     */
    public void addNoteListener(BiConsumer<String, Predicate<Snapshot>> listener) {
        notes.add(listener);
    }

    /** Adds a listener for positions on the canvas at which the user requests a menu. */
    public void addMenuListener(Consumer<Point> listener) {
        menus.add(listener);
    }

    /** Lets the user move the robot before the run has started, to start poses where there is room for it. */
    public void addStartListener(Consumer<Pose> listener) {
        starts.add(listener);
    }

    /** Reports why something was not done, and whether the reason still holds in a world. */
    void fireNote(String sentence, Predicate<Snapshot> holds) {
        notes.forEach(listener -> listener.accept(sentence, holds));
    }

    /** Reports that the user requests a menu at a position on the canvas. */
    public void fireMenuRequested(Point at) {
        menus.forEach(listener -> listener.accept(at));
    }

    /** Reports a new start pose of the robot. */
    void fireStartRequested(Pose pose) {
        starts.forEach(listener -> listener.accept(pose));
    }

    public boolean hasStartListener() {
        return !starts.isEmpty();
    }
}
