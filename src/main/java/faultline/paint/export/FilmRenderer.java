package faultline.paint.export;

import faultline.paint.scene.ScenePainter;
import faultline.paint.surface.Camera;
import faultline.paint.surface.DrawContext;
import faultline.paint.surface.Palette;
import faultline.world.Obstacle;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.List;

/**
 * Renders the images of a film, each with its time. The background with the static obstacles is kept until an edit
 * changes it, because painting a large floor plan takes much longer than everything that moves. Confined to one thread.
 */
public final class FilmRenderer {

    /** What the kept background shows; the size of the world does not change during a run. */
    private record Ground(Camera camera, Palette palette, ScenePainter painter, List<Obstacle> obstacles) {}

    private Ground ground;
    private BufferedImage groundImage;

    /** Returns a new opaque image of a frame of the run. */
    public BufferedImage render(RenderRequest request) {
        keepGround(request);
        BufferedImage image = newImage(request.camera());
        Graphics2D graphics = image.createGraphics();
        try {
            graphics.drawImage(groundImage, 0, 0, null);
            request.painter().paintAboveGround(newContext(graphics, request), request.frame(), request.references());
        } finally {
            graphics.dispose();
        }
        FilmClock.paint(image, request.frame().snapshot().time(), request.palette());
        return image;
    }

    private void keepGround(RenderRequest request) {
        List<Obstacle> obstacles = ScenePainter.staticObstacles(request.frame().snapshot());
        Ground shown = new Ground(request.camera(), request.palette(), request.painter(), obstacles);
        if (shown.equals(ground)) {
            return;
        }
        ground = shown;
        groundImage = newImage(request.camera());
        Graphics2D graphics = groundImage.createGraphics();
        try {
            request.painter()
                    .paintGround(newContext(graphics, request), request.frame().snapshot());
        } finally {
            graphics.dispose();
        }
    }

    private static BufferedImage newImage(Camera camera) {
        return new BufferedImage(camera.width(), camera.height(), BufferedImage.TYPE_INT_RGB);
    }

    private static DrawContext newContext(Graphics2D graphics, RenderRequest request) {
        return new DrawContext(graphics, request.camera(), request.palette());
    }
}
