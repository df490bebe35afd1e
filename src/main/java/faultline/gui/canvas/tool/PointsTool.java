package faultline.gui.canvas.tool;

import faultline.geometry.Vector2;
import faultline.gui.text.Messages;
import faultline.paint.scene.InteractionPainter;
import faultline.paint.surface.DrawContext;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;

/**
 * Collects points by clicks until a double click, Enter, or a click on the first point of a closed shape; a drag draws
 * freehand.
 */
public final class PointsTool implements Tool {

    /** The minimum distance between points of a freehand drawing, pixels. */
    private static final double FREEHAND_SPACING = 12;

    private final ToolContext context;
    private final int minPoints;
    private final boolean closed;
    private final Predicate<List<Vector2>> onComplete;
    private final List<Vector2> points = new ArrayList<>();
    private Vector2 mouse;
    private boolean freeHand;
    private boolean done;

    /**
     * Creates a tool that needs some points and is done when the handler has accepted them. The place of the next point
     * is shown at {@code mouse} until it is moved.
     */
    PointsTool(ToolContext context, Vector2 mouse, int minPoints, boolean closed, Predicate<List<Vector2>> onComplete) {
        this.context = context;
        this.mouse = mouse;
        this.minPoints = minPoints;
        this.closed = closed;
        this.onComplete = onComplete;
    }

    @Override
    public void press(Vector2 at, boolean twice) {
        mouse = at;
        if (twice || closesShape(at)) {
            finish();
        } else if (points.isEmpty() || context.isBeyondClickTolerance(lastPoint(), at)) {
            points.add(at);
        }
    }

    /** Returns whether a click on the first point closes the shape. */
    private boolean closesShape(Vector2 at) {
        return closed && points.size() >= Math.max(minPoints, 3) && !context.isBeyondClickTolerance(points.get(0), at);
    }

    private Vector2 lastPoint() {
        return points.get(points.size() - 1);
    }

    @Override
    public void move(Vector2 at, boolean down) {
        mouse = at;
        if (down && !points.isEmpty() && context.pixelDistance(lastPoint(), at) >= FREEHAND_SPACING) {
            points.add(at);
            freeHand |= points.size() > 2;
        }
    }

    @Override
    public void release(Vector2 at) {
        if (freeHand && points.size() >= minPoints) {
            finish();
        }
        freeHand = false;
    }

    @Override
    public void finish() {
        if (points.size() >= minPoints) {
            done = onComplete.test(List.copyOf(points));
        } else {
            context.showNote(Messages.get("tool.points", Integer.toString(minPoints)));
        }
    }

    @Override
    public void removeLastPoint() {
        if (!points.isEmpty()) {
            points.remove(points.size() - 1);
        }
    }

    @Override
    public boolean isDone() {
        return done;
    }

    @Override
    public void paint(DrawContext drawContext) {
        List<Vector2> sketch = new ArrayList<>(points);
        sketch.add(mouse);
        InteractionPainter.paintSketch(drawContext, sketch, closed);
    }
}
