package faultline.gui.canvas;

import faultline.geometry.Vec;
import faultline.gui.text.Texts;
import faultline.paint.Brush;
import faultline.paint.HandPainter;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;

/** Takes points, one a click, until a double click, Enter, or a click on the first one where that closes a figure; a drag draws free hand. */
final class PointsTool implements Tool {

    /** Points of a free hand are no nearer than this, pixels. */
    private static final double FREE_HAND = 12;

    private final Desk desk;
    private final int least;
    private final boolean closed;
    private final Predicate<List<Vec>> use;
    private final List<Vec> points = new ArrayList<>();
    private Vec mouse = Vec.ZERO;
    private boolean freeHand;
    private boolean done;

    /** A tool that needs some points at least and is done when they were of use. */
    PointsTool(Desk desk, int least, boolean closed, Predicate<List<Vec>> use) {
        this.desk = desk;
        this.least = least;
        this.closed = closed;
        this.use = use;
    }

    @Override
    public void press(Vec at, boolean twice) {
        mouse = at;
        if (twice || closes(at)) {
            finish();
        } else if (points.isEmpty() || desk.isFar(last(), at)) {
            points.add(at);
        }
    }

    /** A click on the first point closes a figure. */
    private boolean closes(Vec at) {
        return closed && points.size() >= Math.max(least, 3) && !desk.isFar(points.get(0), at);
    }

    private Vec last() {
        return points.get(points.size() - 1);
    }

    @Override
    public void move(Vec at, boolean down) {
        mouse = at;
        if (down && !points.isEmpty() && desk.pixels(last(), at) >= FREE_HAND) {
            points.add(at);
            freeHand |= points.size() > 2;
        }
    }

    @Override
    public void release(Vec at) {
        if (freeHand && points.size() >= least) {
            finish();
        }
        freeHand = false;
    }

    @Override
    public void finish() {
        if (points.size() >= least) {
            done = use.test(List.copyOf(points));
        } else {
            desk.note(Texts.text("tool.points", Integer.toString(least)));
        }
    }

    @Override
    public void back() {
        if (!points.isEmpty()) {
            points.remove(points.size() - 1);
        }
    }

    @Override
    public boolean isDone() {
        return done;
    }

    @Override
    public void paint(Brush brush) {
        List<Vec> sketch = new ArrayList<>(points);
        sketch.add(mouse);
        HandPainter.paintSketch(brush, sketch, closed);
    }
}
