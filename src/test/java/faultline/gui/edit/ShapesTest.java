package faultline.gui.edit;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.geometry.Degrees;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.gui.text.Messages;
import faultline.scenario.xml.ScenarioLimits;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.WaypointPath;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.function.ToDoubleFunction;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** New obstacles and the handles that change them. */
class ShapesTest {

    @Test
    void aRectangleIsDrawnFromCornerToCorner() {
        Obstacle box = ShapePreset.RECTANGLE.createBetween("box", new Vector2(2, 3), new Vector2(1, 2.5));
        assertEquals(new Obstacle("box", new ObstacleShape.RectangleShape(1, 0.5), new Pose(1.5, 2.75, 0)), box);
    }

    @Test
    void anIdIsInTheWordsOfTheMenu() {
        for (ShapePreset shape : ShapePreset.values()) {
            String item = Messages.get("action.place" + shape.name().charAt(0)
                    + shape.name().substring(1).toLowerCase(Locale.ROOT));
            assertEquals(item.replace("&", "").replace(' ', '-').toLowerCase(Locale.ROOT), shape.id());
        }
    }

    @Test
    void aRegularShapeTakesTheLongerSideForBoth() {
        Obstacle circle = ShapePreset.CIRCLE.createBetween("pole", new Vector2(2, 3), new Vector2(3, 2.9));
        assertEquals(new Obstacle("pole", new ObstacleShape.CircleShape(0.5), new Pose(2.5, 2.5, 0)), circle);
    }

    @ParameterizedTest
    @EnumSource
    void everyShapeOfThePaletteIsCentredOnTheClick(ShapePreset shape) {
        Obstacle placed = shape.createAt("new", new Vector2(2, 1));
        assertEquals(new Pose(2, 1, 0), placed.pose());
        List<Vector2> handles = ShapeHandles.positions(placed);
        assertEquals(2, middle(handles, Vector2::x), 1e-8);
        assertEquals(1, middle(handles, Vector2::y), 1e-8);
    }

    private static double middle(List<Vector2> points, ToDoubleFunction<Vector2> coordinate) {
        DoubleSummaryStatistics bounds = points.stream().mapToDouble(coordinate).summaryStatistics();
        return (bounds.getMin() + bounds.getMax()) / 2;
    }

    @ParameterizedTest
    @EnumSource
    void aShapeIsAsLargeAsTheRectangleThatWasDragged(ShapePreset shape) {
        Obstacle placed = shape.createBetween("new", new Vector2(1, 1), new Vector2(2.2, 1.8));
        double height =
                switch (shape) {
                    case SQUARE, CIRCLE -> 1.2;
                    case HEXAGON -> 1.2 * Math.sqrt(3) / 2;
                    default -> 0.8;
                };
        List<Vector2> handles = ShapeHandles.positions(placed);
        assertEquals(1.2, size(handles, Vector2::x), 1e-4);
        assertEquals(height, size(handles, Vector2::y), 1e-4);
    }

    private static double size(List<Vector2> points, ToDoubleFunction<Vector2> coordinate) {
        DoubleSummaryStatistics bounds = points.stream().mapToDouble(coordinate).summaryStatistics();
        return bounds.getMax() - bounds.getMin();
    }

    @Test
    void aSideOfARectangleChangesOneOfItsSizes() {
        Obstacle box = new Obstacle("box", new ObstacleShape.RectangleShape(1, 1), new Pose(2, 2, 0));
        assertEquals(
                new Obstacle("box", new ObstacleShape.RectangleShape(1, 2), new Pose(2, 2.5, 0)),
                ShapeHandles.dragHandle(box, 1, new Vector2(2.3, 3.5), SnapSettings.NONE));
        assertEquals(
                new Obstacle("box", new ObstacleShape.RectangleShape(1.8, 1), new Pose(1.6, 2, 0)),
                ShapeHandles.dragHandle(box, 3, new Vector2(0.7, 2.2), SnapSettings.NONE));
    }

    @Test
    void onlyWithoutAGridACoordinateThatIsAsBeforeIsNotRounded() {
        Vector2 before = new Vector2(1.23456789, 2.3456789);
        assertEquals(new Vector2(1.23456789, 2), SnapSettings.NONE.point(before, new Vector2(1.23456789, 1.99999)));
        assertEquals(new Vector2(1, 2.3456789), SnapSettings.NONE.point(before, new Vector2(1.00001, 2.3456789)));
        assertEquals(new Vector2(1.2, 2.3), new SnapSettings(0.1, 0).point(before, before));
    }

    @Test
    void theHandlesOfAnEllipseAreTheEndsOfItsAxesAndChangeThemAlone() {
        Obstacle pond = new Obstacle("pond", new ObstacleShape.EllipseShape(0.6, 0.2), new Pose(2, 1, 0));
        assertEquals(
                List.of(new Vector2(2.6, 1), new Vector2(1.4, 1), new Vector2(2, 1.2), new Vector2(2, 0.8)),
                ShapeHandles.positions(pond));
        assertEquals(
                new ObstacleShape.EllipseShape(0.9, 0.2),
                ShapeHandles.dragHandle(pond, 1, new Vector2(1.1, 1.7), SnapSettings.NONE)
                        .shape());
        assertEquals(
                new ObstacleShape.EllipseShape(0.6, 0.3),
                ShapeHandles.dragHandle(pond, 2, new Vector2(2.4, 1.3), SnapSettings.NONE)
                        .shape());
    }

    @Test
    void theFrameOfDrawnPointsIsTheCentreOfTheirBounds() {
        Obstacle wall = PointShapes.wall("wall", List.of(new Vector2(0.1, 0.2), new Vector2(0.3, 0.6)));
        assertEquals(new Pose(0.2, 0.4, 0), wall.pose());
        assertEquals(
                new ObstacleShape.WallShape(List.of(new Vector2(-0.1, -0.2), new Vector2(0.1, 0.2))), wall.shape());
    }

    @Test
    void everyHandleOfARotatedRectangleLeavesTheOppositeOneInPlace() {
        Obstacle box =
                new Obstacle("box", new ObstacleShape.RectangleShape(1, 0.5), new Pose(2, 1, Degrees.toRadians(30)));
        for (int handle = 0; handle < 8; handle++) {
            Vector2 opposite = ShapeHandles.positions(box).get((handle + 4) % 8);
            Obstacle larger = ShapeHandles.dragHandle(
                    box, handle, ShapeHandles.positions(box).get(handle).times(1.1), SnapSettings.NONE);
            assertEquals(0, ShapeHandles.positions(larger).get((handle + 4) % 8).distanceTo(opposite), 1e-8);
        }
    }

    @Test
    void sizesSnapAndStayPositive() {
        Obstacle pole = new Obstacle("pole", new ObstacleShape.CircleShape(0.2), new Pose(2, 1, 0));
        assertEquals(
                new ObstacleShape.CircleShape(0.35),
                ShapeHandles.dragHandle(pole, 0, new Vector2(2.337, 1), new SnapSettings(0.05, 0))
                        .shape());
        assertEquals(
                new ObstacleShape.CircleShape(0.01),
                ShapeHandles.dragHandle(pole, 0, new Vector2(2, 1), new SnapSettings(0.05, 0))
                        .shape());
    }

    @Test
    void aCornerOfAPolygonIsDraggedAlone() {
        Obstacle triangle = PointShapes.polygon("t", List.of(new Vector2(0, 0), new Vector2(2, 0), new Vector2(0, 2)));
        Obstacle changed = ShapeHandles.dragHandle(triangle, 1, new Vector2(3, 0.5), SnapSettings.NONE);
        assertEquals(
                List.of(new Vector2(0, 0), new Vector2(3, 0.5), new Vector2(0, 2)), ShapeHandles.positions(changed));
    }

    @Test
    void aGlossyObstacleStaysGlossyWhenItIsCopiedAndReshaped() {
        Obstacle glass = new Obstacle(
                "glass",
                new ObstacleShape.RectangleShape(1, 0.5),
                new Pose(2, 1, 0),
                WaypointPath.NONE,
                Degrees.toRadians(8));
        Obstacle copy = ObstacleCopies.copyOf(List.of(glass), Set.of("glass"), new Vector2(0.2, -0.2))
                .get(0);
        assertEquals(glass.specularAngle(), copy.specularAngle());
        assertEquals("glass-2", copy.id());
        assertEquals(
                glass.specularAngle(),
                ShapeHandles.dragHandle(glass, 0, new Vector2(3, 2), SnapSettings.NONE)
                        .specularAngle());
    }

    @Test
    void anIdThatIsTakenGetsTheNextNumber() {
        assertEquals("circle", IdGenerator.uniqueId("circle", Set.of("box")));
        assertEquals("circle-3", IdGenerator.uniqueId("circle", Set.of("circle", "circle-2")));
        assertEquals("circle-3", IdGenerator.uniqueId("circle-2", Set.of("circle", "circle-2")));
    }

    @Test
    void theCopyOfAnObstacleWithTheLongestIdHasAnIdThatAFileMayHold() {
        String longest = "x".repeat(ScenarioLimits.MAX_ID_LENGTH);
        String second = "x".repeat(ScenarioLimits.MAX_ID_LENGTH - 2) + "-2";
        assertEquals(second, IdGenerator.uniqueId(longest, Set.of(longest)));
        assertEquals(
                "x".repeat(ScenarioLimits.MAX_ID_LENGTH - 2) + "-3",
                IdGenerator.uniqueId(longest, Set.of(longest, second)));
    }
}
