package faultline.gui.canvas;

import faultline.engine.Frame;
import faultline.geometry.Vec;
import faultline.paint.Layer;
import faultline.paint.Palette;
import faultline.world.Command;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import javax.swing.JComponent;

/** The picture of the world in the window. It shows the newest frame it was given, the badge of the first collision included. */
public final class SimulationCanvas extends JComponent {

    private final Consumer<Command> commands;
    private final Set<Layer> layers = Layer.usual();
    private Palette palette = Palette.LIGHT;
    private Optional<Frame> frame = Optional.empty();
    private boolean following;

    /**
     * A canvas without a frame.
     *
     * @param commands where moves of obstacles go; called on the event dispatch thread
     */
    public SimulationCanvas(Consumer<Command> commands) {
        this.commands = Objects.requireNonNull(commands, "commands");
    }

    /**
     * Shows a frame from now on. The first one, and one of a world of another size, is fitted into the canvas.
     *
     * @param newest the frame
     */
    public void show(Frame newest) {
        frame = Optional.of(newest);
        repaint();
    }

    /**
     * The frame that shows.
     *
     * @return empty before the first
     */
    public Optional<Frame> frame() {
        return frame;
    }

    /**
     * Paints in other colours from now on.
     *
     * @param newPalette the colours
     */
    public void setPalette(Palette newPalette) {
        palette = newPalette;
        repaint();
    }

    /**
     * Shows or hides a layer.
     *
     * @param layer the layer
     * @param on whether it is to show
     */
    public void setLayer(Layer layer, boolean on) {
    }

    /**
     * Whether a layer shows.
     *
     * @param layer the layer
     * @return true where it does
     */
    public boolean isLayerOn(Layer layer) {
        return layers.contains(layer);
    }

    /** Shows the whole world, and goes on doing so when the canvas is resized, until the hand zooms or pans. */
    public void fit() {
    }

    /** Zooms in on the middle. */
    public void zoomIn() {
    }

    /** Zooms out from the middle. */
    public void zoomOut() {
    }

    /**
     * The scale of the picture.
     *
     * @return pixels per metre
     */
    public double pixelsPerMetre() {
        return 1;
    }

    /**
     * Keeps the robot in view from now on, or no longer.
     *
     * @param follow whether to follow
     */
    public void setFollowing(boolean follow) {
        following = follow;
    }

    /**
     * Whether the robot is kept in view.
     *
     * @return true where it is
     */
    public boolean isFollowing() {
        return following;
    }

    /**
     * Tells a listener, from now on, which point of the world is under the mouse.
     *
     * @param listener gets metres, empty where the mouse has left the canvas
     */
    public void addCursorListener(Consumer<Optional<Vec>> listener) {
    }

    /**
     * Tells a listener, from now on, how large the picture's scale is whenever it changes.
     *
     * @param listener gets pixels per metre
     */
    public void addZoomListener(Consumer<Double> listener) {
    }

    /**
     * The obstacle that is selected.
     *
     * @return its id, empty where none is
     */
    public Optional<String> selectedObstacle() {
        return Optional.empty();
    }

    /**
     * Selects an obstacle or none.
     *
     * @param obstacle its id, empty for none
     */
    public void select(Optional<String> obstacle) {
    }

    /**
     * Tells a listener, from now on, what is selected whenever that changes.
     *
     * @param listener gets the obstacle's id, empty where none is selected
     */
    public void addSelectionListener(Consumer<Optional<String>> listener) {
    }
}
