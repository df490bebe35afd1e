package faultline.gui.canvas.tool;

import faultline.geometry.Vector2;
import faultline.gui.edit.CommandSender;
import faultline.gui.edit.SnapSettings;
import faultline.gui.text.Messages;
import faultline.paint.scene.InteractionPainter;
import faultline.paint.scene.ObstacleGroup;
import faultline.paint.scene.ObstacleOutlines;
import faultline.paint.surface.DrawContext;
import faultline.world.Obstacle;
import java.util.List;
import java.util.function.UnaryOperator;

/** One drag, from the press of the button on. It has no effect until the mouse has moved further than a click. */
public final class DragGesture implements Gesture {

    /** The largest number of obstacles that are painted apart from the cached ground while they are dragged. */
    private static final int MAX_SEPARATE_PREVIEWS = 16;

    /** The largest number of their corners. */
    private static final int MAX_SEPARATE_CORNERS = 2000;

    private DragOperation operation;
    private final Vector2 pressed;
    private final CanvasModel model;
    private final Viewport viewport;
    private final CommandSender sender;
    private DragPreview preview;
    /** The obstacles of the preview that was painted last. */
    private ObstacleGroup shown = ObstacleGroup.NONE;

    private Vector2 last;

    DragGesture(DragOperation operation, Vector2 pressed, CanvasModel model, Viewport viewport, CommandSender sender) {
        this.operation = operation;
        this.pressed = pressed;
        this.model = model;
        this.viewport = viewport;
        this.sender = sender;
        this.last = pressed;
        sender.beginGesture();
    }

    @Override
    public void moveTo(Vector2 screen, SnapSettings snap) {
        last = screen;
        if (preview != null || screen.distanceTo(pressed) >= CLICK_TOLERANCE) {
            applyPreview(operation.preview(viewport.camera().get().toWorld(screen), snap));
        }
    }

    private void applyPreview(DragPreview wanted) {
        boolean isNew = preview == null || !preview.commands().equals(wanted.commands());
        preview = wanted;
        if (isNew && (model.hasStarted() || blocked().isEmpty())) {
            sender.send(wanted.commands());
        }
    }

    /**
     * Returns the obstacles that would overlap the robot. A run that has started has a collision there; before that,
     * the obstacles stay where they were last.
     */
    private List<Obstacle> blocked() {
        return preview.obstacles().stream()
                .filter(obstacle -> PlacementCheck.overlapsRobot(model, obstacle))
                .toList();
    }

    @Override
    public void release() {
        sender.endGesture();
    }

    @Override
    public void discard() {
        sender.endGesture();
    }

    @Override
    public void cancel() {
        if (preview != null) {
            sender.send(operation.restoreCommands());
        }
        sender.endGesture();
    }

    @Override
    public boolean isTargetGone() {
        return !model.obstacleIds()
                .containsAll(operation.obstacles().stream().map(Obstacle::id).toList());
    }

    @Override
    public void renameObstacles(UnaryOperator<String> nextId) {
        UnaryOperator<Obstacle> named = obstacle -> obstacle.withId(nextId.apply(obstacle.id()));
        operation = operation.renamed(named);
        if (preview != null) {
            List<Obstacle> there = preview.obstacles().stream().map(named).toList();
            preview = new DragPreview(preview.commands(), there, preview.valueText());
        }
    }

    @Override
    public void paint(DrawContext context) {
        if (preview == null) {
            return;
        }
        List<Obstacle> blocked = blocked();
        shown = shown.with(preview.obstacles());
        paintPreview(context, blocked);
        if (blocked.isEmpty()) {
            InteractionPainter.paintValues(context, preview.valueText(), shown, last);
        } else {
            InteractionPainter.paintRefusal(
                    context, Messages.get("refused.robot", blocked.get(0).id()), shown, last);
        }
    }

    /**
     * Returns whether obstacles are so few and small that each is painted in every frame while they are dragged; if
     * not, their bounding box is the preview.
     */
    public static boolean isPreviewedInFull(List<Obstacle> obstacles) {
        return obstacles.size() <= MAX_SEPARATE_PREVIEWS
                && obstacles.stream()
                                .mapToInt(obstacle -> ObstacleOutlines.cornerCount(obstacle.shape()))
                                .sum()
                        <= MAX_SEPARATE_CORNERS;
    }

    private void paintPreview(DrawContext context, List<Obstacle> blocked) {
        if (isPreviewedInFull(preview.obstacles())) {
            preview.obstacles()
                    .forEach(
                            obstacle -> InteractionPainter.paintPreview(context, obstacle, blocked.contains(obstacle)));
        } else {
            InteractionPainter.paintPreview(context, shown, !blocked.isEmpty());
        }
    }
}
