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
import faultline.gui.edit.CommandSender;
import faultline.gui.text.Messages;
import faultline.gui.theme.AccessibleComponent;
import faultline.gui.theme.FocusRing;
import faultline.gui.theme.RefreshSteps;
import faultline.paint.export.RenderRequest;
import faultline.paint.scene.CornerChoice;
import faultline.paint.scene.Layer;
import faultline.paint.scene.ReferenceOverlay;
import faultline.paint.scene.ScenePainter;
import faultline.paint.surface.Camera;
import faultline.paint.surface.DrawContext;
import faultline.paint.surface.Palette;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import java.util.stream.Stream;
import javax.accessibility.AccessibleRole;

/**
 * Shows the newest frame, with the report of the first collision, and sends the user's edits of obstacles and sensors
 * as commands, whose effect is shown with a later frame.
 */
public final class SimulationCanvas extends AccessibleComponent {

    private static final double ZOOM_STEP = 1.25;

    private final CanvasModel model = new CanvasModel();
    private final Viewport viewport = new Viewport();
    private final CachedSceneRenderer renderer;
    private final BackBuffer backBuffer = new BackBuffer();
    private final CanvasMouse mouse;
    private final CanvasTools tools;
    private final FocusRing focusRing = new FocusRing(this);
    private Palette palette = Palette.LIGHT;
    /** Null if no listener waits for the next frame. */
    private transient Runnable paintListener;

    /** Creates a canvas without a frame, given what sends its commands. */
    public SimulationCanvas(CommandSender sender) {
        this(sender, System::nanoTime);
    }

    /** Creates a canvas with a clock, in nanoseconds, that limits the time to paint a frame. */
    SimulationCanvas(CommandSender sender, LongSupplier clock) {
        super(AccessibleRole.CANVAS);
        renderer = new CachedSceneRenderer(clock);
        CanvasListeners listeners = new CanvasListeners();
        mouse = new CanvasMouse(viewport, new GesturePicker(model, viewport, sender, listeners), listeners);
        ToolContext context = new ToolContext(model, viewport, sender, listeners);
        tools = new CanvasTools(context, mouse, this);
        new CanvasKeys(context, mouse).install(this);
        mouse.install(this);
        model.selection().addListener(selected -> repaint());
        model.sensor().addListener(selected -> repaint());
        model.referenceOverlay().addListener(overlay -> repaint());
        viewport.camera().addListener(camera -> repaint());
        setFocusable(true);
        setOpaque(true);
        setPreferredSize(new Dimension(800, 560));
        RefreshSteps.add(this, SimulationCanvas::describe);
    }

    private void describe() {
        getAccessibleContext().setAccessibleName(Messages.get("canvas"));
        getAccessibleContext().setAccessibleDescription(Messages.get("canvas.description"));
    }

    /** Shows a frame. The first one of a scenario, and one of a world of another size, is fitted into the canvas. */
    public void setFrame(Frame newest) {
        assert EventQueue.isDispatchThread();
        model.setFrame(newest);
        mouse.releaseIfTargetGone();
        viewport.setWorld(newest.snapshot());
        repaint();
    }

    /** Returns the frame that is shown; empty before the first. */
    public Optional<Frame> frame() {
        return model.frame();
    }

    /**
     * Returns a request to render what is shown in other colours, without tools and selection; empty before the first
     * frame.
     */
    public Optional<RenderRequest> renderRequest(Palette newPalette) {
        assert EventQueue.isDispatchThread();
        return frame().map(now -> new RenderRequest(
                now,
                camera(),
                newPalette,
                new ScenePainter(model.layers(), LocalizedLabels.create(DrawContext.DEFAULT_FONT)),
                model.referenceOverlay().get().stream().toList()));
    }

    /** Sets the colours. */
    public void setPalette(Palette newPalette) {
        assert EventQueue.isDispatchThread();
        palette = newPalette;
        repaint();
    }

    /** Shows a reference run, null for none. */
    public void setReferenceOverlay(ReferenceOverlay overlay) {
        assert EventQueue.isDispatchThread();
        model.referenceOverlay().set(Optional.ofNullable(overlay));
    }

    /** Shows or hides a layer. */
    public void setLayer(Layer layer, boolean on) {
        assert EventQueue.isDispatchThread();
        model.setLayer(layer, on);
        repaint();
    }

    /** Returns whether a layer is shown. */
    public boolean isLayerOn(Layer layer) {
        return model.layers().contains(layer);
    }

    /** Sets whether the first collision is reported; a component on top of the canvas may report it instead. */
    public void setCollisionReported(boolean reported) {
        assert EventQueue.isDispatchThread();
        if (reported != model.isCollisionReported()) {
            model.setCollisionReported(reported);
            repaint();
        }
    }

    /** Fits the whole world into the canvas, also when the canvas is resized, until the user zooms or pans. */
    public void fit() {
        assert EventQueue.isDispatchThread();
        viewport.fit();
    }

    /** Zooms in on the centre. */
    public void zoomIn() {
        assert EventQueue.isDispatchThread();
        viewport.zoom(ZOOM_STEP);
    }

    /** Zooms out from the centre. */
    public void zoomOut() {
        assert EventQueue.isDispatchThread();
        viewport.zoom(1 / ZOOM_STEP);
    }

    /** Returns the mapping between the world and the canvas. */
    public Camera camera() {
        return viewport.camera().get();
    }

    /** Sets whether the robot is kept in view. */
    public void setFollowing(boolean follow) {
        assert EventQueue.isDispatchThread();
        viewport.setFollowing(follow);
    }

    /** Returns whether the robot is kept in view. */
    public boolean isFollowing() {
        return viewport.isFollowing();
    }

    /** Adds a listener for the point of the world under the mouse, metres; empty if the mouse has left the canvas. */
    public void addCursorListener(Consumer<Optional<Vector2>> listener) {
        mouse.cursorPoint().addListener(listener);
    }

    /** Adds a listener for changes of the camera. */
    public void addCameraListener(Consumer<Camera> listener) {
        viewport.camera().addListener(listener);
    }

    /** Returns the tools, the snap settings and the selection of the canvas. */
    public CanvasTools tools() {
        return tools;
    }

    /** Calls a listener once, on the event dispatch thread, after the next frame has been painted. */
    public void runAfterNextPaint(Runnable listener) {
        assert EventQueue.isDispatchThread();
        paintListener = listener;
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

    /** Returns the bounds of the components on top of the canvas. */
    private List<Rectangle2D> covered() {
        return Stream.of(getComponents())
                .filter(Component::isVisible)
                .<Rectangle2D>map(Component::getBounds)
                .toList();
    }

    /** Returns where the robot is and where it is heading, pixels; empty before the first frame. */
    public Optional<Rectangle2D> robotArea() {
        return frame().map(Frame::snapshot).map(world -> CornerChoice.robotArea(camera(), world.robot(), world.pose()));
    }

    private void paintScene(Graphics2D graphics) {
        graphics.setColor(palette.canvas());
        graphics.fillRect(0, 0, getWidth(), getHeight());
        if (model.frame().isPresent()) {
            renderer.paint(graphics, camera(), palette, model, covered());
            mouse.paint(new DrawContext(graphics, camera(), palette).withFont(LocalizedLabels.font()));
        }
        if (!renderer.isComplete()) {
            repaint();
        }
        if (model.frame().isPresent() && paintListener != null) {
            EventQueue.invokeLater(paintListener);
            paintListener = null;
        }
    }
}
