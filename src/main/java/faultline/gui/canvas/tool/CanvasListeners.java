package faultline.gui.canvas.tool;

import faultline.geometry.Pose;
import java.awt.Point;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;

/** The listeners of a canvas. */
public final class CanvasListeners {

    private final List<Consumer<String>> notes = new ArrayList<>();
    private final List<Consumer<Point>> menus = new ArrayList<>();
    private final List<Consumer<Pose>> starts = new ArrayList<>();

    /** Adds a listener for sentences that say why something was not done. */
    public void addNoteListener(Consumer<String> listener) {
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

    /** Reports why something was not done. */
    void fireNote(String sentence) {
        notes.forEach(listener -> listener.accept(sentence));
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
