package faultline.gui.canvas;

import faultline.engine.Frame;
import faultline.geometry.Vec;
import faultline.gui.edit.Editor;
import faultline.gui.text.Texts;
import faultline.gui.theme.FocusRing;
import faultline.paint.Brush;
import faultline.paint.Camera;
import faultline.paint.Ghost;
import faultline.paint.Layer;
import faultline.paint.Palette;
import faultline.paint.ScenePainter;
import faultline.paint.Shot;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import javax.accessibility.AccessibleContext;
import javax.accessibility.AccessibleRole;
import javax.swing.JComponent;

/**
 * The picture of the world in the window. It shows the newest frame that it was given, the badge of the first collision included,
 * and sends what mouse and keys do to obstacles as commands; what they change shows when a frame brings it back.
 */
public final class SimulationCanvas extends JComponent {

    private static final double ZOOM_STEP = 1.25;

    private final Scene scene = new Scene();
    private final Viewpoint viewpoint = new Viewpoint();
    private final Picture picture;
    private final Plate plate = new Plate();
    private final Set<Layer> layers = Layer.usual();
    private final Courier courier;
    private final Hand hand;
    private final CanvasTools tools;
    private final FocusRing ring = new FocusRing(this);
    private Palette palette = Palette.LIGHT;
    private Optional<Runnable> painted = Optional.empty();

    /**
     * A canvas without a frame.
     *
     * @param editor gets what the hand does
     */
    public SimulationCanvas(Editor editor) {
        this(editor, System::nanoTime);
    }

    /** A canvas that looks at a clock, nanoseconds, to see when it has painted long enough. */
    SimulationCanvas(Editor editor, LongSupplier clock) {
        picture = new Picture(clock);
        Watchers watchers = new Watchers();
        courier = new Courier(Objects.requireNonNull(editor, "editor"));
        hand = new Hand(viewpoint, new Grips(scene, viewpoint, courier, watchers), watchers);
        tools = new CanvasTools(new Desk(scene, viewpoint, editor, watchers), hand, this);
        new Keys(scene, courier, hand).install(this);
        addMouseListener(hand);
        addMouseMotionListener(hand);
        addMouseWheelListener(hand);
        scene.selection().listen(selected -> repaint());
        scene.sensor().listen(selected -> repaint());
        scene.ghost().listen(ghost -> repaint());
        viewpoint.camera().listen(camera -> repaint());
        setFocusable(true);
        setOpaque(true);
        setPreferredSize(new Dimension(800, 560));
    }

    /**
     * Shows a frame from now on. The first one, and one of a world of another size, is fitted into the canvas.
     *
     * @param newest the frame
     */
    public void show(Frame newest) {
        assert EventQueue.isDispatchThread();
        scene.show(newest);
        courier.frameShown(scene.obstacles());
        hand.frameShown();
        viewpoint.show(newest.world());
        repaint();
    }

    /**
     * The frame that shows.
     *
     * @return empty before the first
     */
    public Optional<Frame> frame() {
        return scene.frame();
    }

    /**
     * What shows now, to be painted elsewhere; the marks of a hand at work are left out.
     *
     * @param colours to paint it in
     * @return empty before the first frame
     */
    public Optional<Shot> shot(Palette colours) {
        assert EventQueue.isDispatchThread();
        return frame().map(now -> new Shot(now, camera(), colours, new ScenePainter(layers, PictureWords.spoken(Brush.FONT)), scene.ghost().get()));
    }

    /**
     * Paints in other colours from now on.
     *
     * @param newPalette the colours
     */
    public void setPalette(Palette newPalette) {
        assert EventQueue.isDispatchThread();
        palette = newPalette;
        repaint();
    }

    /**
     * Shows an earlier run beside this one from now on.
     *
     * @param ghost the earlier run, empty for none
     */
    public void setGhost(Optional<Ghost> ghost) {
        assert EventQueue.isDispatchThread();
        scene.ghost().set(ghost);
    }

    /**
     * Shows or hides a layer.
     *
     * @param layer the layer
     * @param on whether it is to show
     */
    public void setLayer(Layer layer, boolean on) {
        assert EventQueue.isDispatchThread();
        if (on) {
            layers.add(layer);
        } else {
            layers.remove(layer);
        }
        repaint();
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
        assert EventQueue.isDispatchThread();
        viewpoint.fit();
    }

    /** Zooms in on the middle. */
    public void zoomIn() {
        assert EventQueue.isDispatchThread();
        viewpoint.zoom(ZOOM_STEP);
    }

    /** Zooms out from the middle. */
    public void zoomOut() {
        assert EventQueue.isDispatchThread();
        viewpoint.zoom(1 / ZOOM_STEP);
    }

    /**
     * Where the canvas looks.
     *
     * @return the camera, which says what point of the world is where on the canvas and how many pixels a metre has
     */
    public Camera camera() {
        return viewpoint.camera().get();
    }

    /**
     * Keeps the robot in view from now on, or no longer.
     *
     * @param follow whether to follow
     */
    public void setFollowing(boolean follow) {
        assert EventQueue.isDispatchThread();
        viewpoint.setFollowing(follow);
    }

    /**
     * Whether the robot is kept in view.
     *
     * @return true where it is
     */
    public boolean isFollowing() {
        return viewpoint.isFollowing();
    }

    /**
     * Tells a listener, from now on, which point of the world is under the mouse.
     *
     * @param listener gets metres, empty where the mouse has left the canvas
     */
    public void addCursorListener(Consumer<Optional<Vec>> listener) {
        hand.cursor().listen(listener);
    }

    /**
     * Tells a listener, from now on, where the canvas looks whenever that changes.
     *
     * @param listener gets the camera
     */
    public void addCameraListener(Consumer<Camera> listener) {
        viewpoint.camera().listen(listener);
    }

    /**
     * What the hand does with the canvas beyond looking: tools, snapping, and what is selected.
     *
     * @return of this canvas
     */
    public CanvasTools tools() {
        return tools;
    }

    /**
     * Tells once, soon, that a frame has been painted.
     *
     * @param listener told on the event dispatch thread, after the next painting of a frame
     */
    public void whenPainted(Runnable listener) {
        assert EventQueue.isDispatchThread();
        painted = Optional.of(listener);
    }

    @Override
    public void setBounds(int x, int y, int width, int height) {
        super.setBounds(x, y, width, height);
        viewpoint.resize(width, height);
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D own = (Graphics2D) graphics.create();
        try {
            plate.paint(own, getWidth(), getHeight(), this::paintScene);
        } finally {
            own.dispose();
        }
        ring.paint(graphics);
    }

    private void paintScene(Graphics2D graphics) {
        graphics.setColor(palette.canvas());
        graphics.fillRect(0, 0, getWidth(), getHeight());
        scene.frame().ifPresent(frame -> {
            picture.paint(graphics, camera(), palette, layers, frame, scene);
            hand.paint(new Brush(graphics, camera(), palette).lettered(PictureWords.font()));
        });
        if (!picture.isComplete()) {
            repaint();
        }
        if (scene.frame().isPresent()) {
            painted.ifPresent(EventQueue::invokeLater);
            painted = Optional.empty();
        }
    }

    @Override
    public AccessibleContext getAccessibleContext() {
        if (accessibleContext == null) {
            accessibleContext = new Accessibility();
            accessibleContext.setAccessibleName(Texts.text("canvas"));
            accessibleContext.setAccessibleDescription(Texts.text("canvas.description"));
        }
        return accessibleContext;
    }

    private final class Accessibility extends AccessibleJComponent {
        @Override
        public AccessibleRole getAccessibleRole() {
            return AccessibleRole.CANVAS;
        }
    }
}
