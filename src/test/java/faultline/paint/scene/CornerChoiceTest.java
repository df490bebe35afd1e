package faultline.paint.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.Frame;
import faultline.engine.SampleFrames;
import faultline.geometry.Pose;
import faultline.paint.export.RenderRequest;
import faultline.paint.scene.CornerChoice.Corner;
import faultline.paint.surface.Camera;
import faultline.paint.surface.Palette;
import faultline.robot.RobotSpec;
import java.awt.Color;
import java.awt.Rectangle;
import java.awt.geom.Rectangle2D;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class CornerChoiceTest {

    private static final Rectangle2D PICTURE = new Rectangle(0, 0, 600, 400);
    private static final Rectangle2D BOX = new Rectangle(0, 0, 200, 100);

    private final CornerChoice choice = new CornerChoice(Corner.LOWER_LEFT, Corner.UPPER_RIGHT, Corner.LOWER_RIGHT);

    private Rectangle place(Rectangle2D... avoided) {
        return choice.place(PICTURE, BOX, List.of(avoided)).getBounds();
    }

    @Test
    void aBoxStaysInItsCornerUntilSomethingIsBelowIt() {
        Rectangle lowerLeft = new Rectangle(0, 300, 200, 100);
        assertEquals(lowerLeft, place());
        assertEquals(lowerLeft, place(new Rectangle(201, 300, 50, 50)));
        Rectangle upperRight = new Rectangle(400, 0, 200, 100);
        assertEquals(upperRight, place(new Rectangle(180, 320, 50, 50)));
        assertEquals(upperRight, place(new Rectangle(300, 200, 50, 50)), "it does not return");
        assertEquals(lowerLeft, place(new Rectangle(500, 80, 50, 50)));
    }

    @Test
    void whereEveryCornerIsTakenLeastIsHidden() {
        Rectangle left = new Rectangle(0, 290, 200, 110);
        Rectangle top = new Rectangle(0, 0, 600, 60);
        Rectangle right = new Rectangle(400, 300, 20, 20);
        assertEquals(new Rectangle(400, 300, 200, 100), place(left, top, right));
    }

    @Test
    void aCornerThatIsFreeOfTheConesIsPreferred() {
        Rectangle2D robot = new Rectangle(250, 200, 60, 60);
        Rectangle2D cone = new Rectangle(150, 250, 100, 100);
        Rectangle2D other = new Rectangle(400, 20, 50, 50);
        Rectangle2D third = new Rectangle(400, 320, 50, 50);
        List<Rectangle2D> robots = List.of(robot);
        assertEquals(new Rectangle(400, 0, 200, 100), choice.place(PICTURE, BOX, robots, List.of(cone)));
        assertEquals(new Rectangle(400, 300, 200, 100), choice.place(PICTURE, BOX, robots, List.of(cone, other)));
        assertEquals(
                new Rectangle(400, 300, 200, 100),
                choice.place(PICTURE, BOX, robots, List.of(cone, other, third)),
                "it stays if no corner is free");
    }

    @Test
    void theWayAheadOfTheRobotIsKeptFree() {
        Camera camera = Camera.fit(new Rectangle(0, 0, 6, 4), 0, 600, 400);
        Rectangle2D east = CornerChoice.robotArea(camera, RobotSpec.DEFAULT, new Pose(3, 2, 0));
        assertTrue(east.contains(300 + 60, 200) && east.contains(300, 200));
        assertFalse(east.contains(300 - 60, 200));
        Rectangle2D north = CornerChoice.robotArea(camera, RobotSpec.DEFAULT, new Pose(3, 2, Math.PI / 2));
        assertTrue(north.contains(300, 200 - 60));
    }

    @ParameterizedTest
    @CsvSource({"0.3, 0.3", "5.7, 3.7", "5.7, 0.3", "0.3, 3.7"})
    void theCaptionOfAReferenceRunHidesNoRobot(double x, double y) {
        Frame frame = SampleFrames.frameOf(new Pose(x, y, 0));
        Camera camera = Camera.fit(new Rectangle(0, 0, 6, 4), 0, 600, 400);
        Color inside = new Color(new RenderRequest(
                        frame,
                        camera,
                        Palette.LIGHT,
                        new ScenePainter(Layer.defaults(), SceneLabels.ENGLISH),
                        List.of(SampleReferenceOverlays.office()))
                .toImage(1)
                .getRGB((int) (100 * x), (int) (100 * (4 - y))));
        assertTrue(Pixels.isSimilar(Palette.LIGHT.robot(), inside), inside.toString());
    }
}
