package faultline.gui.canvas;

import faultline.geometry.Pose;
import java.awt.Point;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;

/** Who is told what the canvas itself cannot do. */
final class Watchers {

    private final List<Consumer<String>> notes = new ArrayList<>();
    private final List<Consumer<Point>> menus = new ArrayList<>();
    private final List<Consumer<Pose>> starts = new ArrayList<>();

    void listenToNotes(Consumer<String> listener) {
        notes.add(listener);
    }

    void listenToMenus(Consumer<Point> listener) {
        menus.add(listener);
    }

    void listenToStarts(Consumer<Pose> listener) {
        starts.add(listener);
    }

    /** Why something was not done. */
    void note(String sentence) {
        notes.forEach(listener -> listener.accept(sentence));
    }

    /** A menu is wanted at a place of the canvas. */
    void menu(Point at) {
        menus.forEach(listener -> listener.accept(at));
    }

    /** The robot is to start elsewhere. */
    void start(Pose pose) {
        starts.forEach(listener -> listener.accept(pose));
    }

    boolean areStartsWanted() {
        return !starts.isEmpty();
    }
}
