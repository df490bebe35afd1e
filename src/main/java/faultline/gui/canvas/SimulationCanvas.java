package faultline.gui.canvas;

import faultline.engine.Frame;
import faultline.geometry.Vector2;
import faultline.gui.canvas.cache.BackBuffer;
import faultline.gui.canvas.tool.CanvasKeys;
import faultline.gui.canvas.tool.CanvasListeners;
import faultline.gui.canvas.tool.CanvasModel;
import faultline.gui.canvas.tool.CanvasMouse;
import faultline.gui.canvas.tool.CanvasTools;
import faultline.gui.canvas.tool.GesturePicker;
import faultline.gui.canvas.tool.ToolContext;
import faultline.gui.canvas.tool.Viewport;
import faultline.gui.edit.UndoController;
import faultline.gui.text.Messages;
import faultline.gui.theme.FocusRing;
import faultline.paint.export.RenderRequest;
import faultline.paint.scene.Layer;
import faultline.paint.scene.ReferenceOverlay;
import faultline.paint.scene.ScenePainter;
import faultline.paint.surface.Camera;
import faultline.paint.surface.DrawContext;
import faultline.paint.surface.Palette;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import javax.accessibility.AccessibleContext;
import javax.accessibility.AccessibleRole;
import javax.swing.JComponent;

/**
 * The picture of the world in the window. It shows the newest frame that it was given, the badge of the first collision
 * included, and sends what mouse and keys do to obstacles as commands; what they change shows when a frame brings it
 * back.
 */
public final class SimulationCanvas extends JComponent {

    private static final double ZOOM_STEP = 1.25;

    private final CanvasModel model = new CanvasModel();
    private final Viewport viewport = new Viewport();
    private final CachedSceneRenderer renderer;
    private final BackBuffer backBuffer = new BackBuffer();
    private final Set<Layer> layers = Layer.defaults();
    private final CanvasMouse mouse;
    private final CanvasTools tools;
    private final FocusRing focusRing = new FocusRing(this);
    private Palette palette = Palette.LIGHT;
    private Optional<Runnable> paintListener = Optional.empty();

    /**
     * A canvas without a frame.
     *
     * @param editor gets what the hand does
     */
    public SimulationCanvas(UndoController editor) {
        this(editor, System::nanoTime);
    }

    /** A canvas that looks at a clock, nanoseconds, to see when it has painted long enough. */
    SimulationCanvas(UndoController editor, LongSupplier clock) {
        renderer = new CachedSceneRenderer(clock);
        CanvasListeners watchers = new CanvasListeners();
        mouse = new CanvasMouse(viewport, new GesturePicker(model, viewport, editor, watchers), watchers);
        tools = new CanvasTools(new ToolContext(model, viewport, editor, watchers), mouse, this);
        new CanvasKeys(model, editor, mouse).install(this);
        addMouseListener(mouse);
        addMouseMotionListener(mouse);
        addMouseWheelListener(mouse);
        model.selection().addListener(selected -> repaint());
        model.sensor().addListener(selected -> repaint());
        model.referenceOverlay().addListener(ghost -> repaint());
        viewport.camera().addListener(camera -> repaint());
        setFocusable(true);
        setOpaque(true);
        setPreferredSize(new Dimension(800, 560));
    }

    /**
     * Shows a frame from now on. The first one, and one of a world of another size, is fitted into the canvas.
     *
     * @param newest the frame
     */
    public void setFrame(Frame newest) {
        assert EventQueue.isDispatchThread();
        model.setFrame(newest);
        mouse.releaseIfTargetGone();
        viewport.setWorld(newest.snapshot());
        repaint();
    }

    /**
     * The frame that shows.
     *
     * @return empty before the first
     */
    public Optional<Frame> frame() {
        return model.frame();
    }

    /**
     * What shows now, to be painted elsewhere; the marks of a hand at work are left out.
     *
     * @param colours to paint it in
     * @return empty before the first frame
     */
    public Optional<RenderRequest> renderRequest(Palette colours) {
        assert EventQueue.isDispatchThread();
        return frame().map(now -> new RenderRequest(
                now,
                camera(),
                colours,
                new ScenePainter(layers, LocalizedLabels.create(DrawContext.DEFAULT_FONT)),
                model.referenceOverlay().get()));
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
    public void setReferenceOverlay(Optional<ReferenceOverlay> ghost) {
        assert EventQueue.isDispatchThread();
        model.referenceOverlay().set(ghost);
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
        viewport.fit();
    }

    /** Zooms in on the middle. */
    public void zoomIn() {
        assert EventQueue.isDispatchThread();
        viewport.zoom(ZOOM_STEP);
    }

    /** Zooms out from the middle. */
    public void zoomOut() {
        assert EventQueue.isDispatchThread();
        viewport.zoom(1 / ZOOM_STEP);
    }

    /**
     * Where the canvas looks.
     *
     * @return the camera, which says what point of the world is where on the canvas and how many pixels a metre has
     */
    public Camera camera() {
        return viewport.camera().get();
    }

    /**
     * Keeps the robot in view from now on, or no longer.
     *
     * @param follow whether to follow
     */
    public void setFollowing(boolean follow) {
        assert EventQueue.isDispatchThread();
        viewport.setFollowing(follow);
    }

    /**
     * Whether the robot is kept in view.
     *
     * @return true where it is
     */
    public boolean isFollowing() {
        return viewport.isFollowing();
    }

    /**
     * Tells a listener, from now on, which point of the world is under the mouse.
     *
     * @param listener gets metres, empty where the mouse has left the canvas
     */
    public void addCursorListener(Consumer<Optional<Vector2>> listener) {
        mouse.cursorPoint().addListener(listener);
    }

    /**
     * Tells a listener, from now on, where the canvas looks whenever that changes.
     *
     * @param listener gets the camera
     */
    public void addCameraListener(Consumer<Camera> listener) {
        viewport.camera().addListener(listener);
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
    public void runAfterNextPaint(Runnable listener) {
        assert EventQueue.isDispatchThread();
        paintListener = Optional.of(listener);
    }

    @Override
    public void setBounds(int x, int y, int width, int height) {
        super.setBounds(x, y, width, height);
        viewport.resize(width, height);
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D own = (Graphics2D) graphics.create();
        try {
            backBuffer.paint(own, getWidth(), getHeight(), this::paintScene);
        } finally {
            own.dispose();
        }
        focusRing.paint(graphics);
    }

    private void paintScene(Graphics2D graphics) {
        graphics.setColor(palette.canvas());
        graphics.fillRect(0, 0, getWidth(), getHeight());
        model.frame().ifPresent(frame -> {
            renderer.paint(graphics, camera(), palette, layers, frame, model);
            mouse.paint(new DrawContext(graphics, camera(), palette).withFont(LocalizedLabels.font()));
        });
        if (!renderer.isComplete()) {
            repaint();
        }
        if (model.frame().isPresent()) {
            paintListener.ifPresent(EventQueue::invokeLater);
            paintListener = Optional.empty();
        }
    }

    @Override
    public AccessibleContext getAccessibleContext() {
        if (accessibleContext == null) {
            accessibleContext = new Accessibility();
            accessibleContext.setAccessibleName(Messages.get("canvas"));
            accessibleContext.setAccessibleDescription(Messages.get("canvas.description"));
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
