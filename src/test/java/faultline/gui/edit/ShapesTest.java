package faultline.gui.edit;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.geometry.Degrees;
import faultline.geometry.Pose;
import faultline.geometry.Vec;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** New obstacles, and handles that change them. */
class ShapesTest {

    @Test
    void aRectangleIsDrawnFromCornerToCorner() {
        Obstacle box = ReadyShape.RECTANGLE.between("box", new Vec(2, 3), new Vec(1, 2.5));
        assertEquals(new Obstacle("box", new ObstacleShape.Rectangle(1, 0.5), new Pose(1.5, 2.75, 0)), box);
    }

    @Test
    void aRegularShapeTakesTheLongerSideForBoth() {
        Obstacle circle = ReadyShape.CIRCLE.between("pole", new Vec(2, 3), new Vec(3, 2.9));
        assertEquals(new Obstacle("pole", new ObstacleShape.Circle(0.5), new Pose(2.5, 2.5, 0)), circle);
    }

    @ParameterizedTest
    @EnumSource
    void everyShapeOfThePaletteStandsAboutTheClick(ReadyShape shape) {
        Obstacle placed = shape.at("new", new Vec(2, 1));
        assertEquals(new Pose(2, 1, 0), placed.pose());
        List<Vec> handles = ShapeHandles.places(placed);
        assertEquals(2, (max(handles.stream().mapToDouble(Vec::x).toArray()) + min(handles.stream().mapToDouble(Vec::x).toArray())) / 2, 1e-8);
    }

    private static double max(double[] values) {
        return java.util.Arrays.stream(values).max().orElseThrow();
    }

    private static double min(double[] values) {
        return java.util.Arrays.stream(values).min().orElseThrow();
    }

    @Test
    void drawnPointsStandAboutTheMiddleOfTheirBoundsWithoutNoise() {
        Obstacle wall = PointShapes.wall("wall", List.of(new Vec(0.1, 0.2), new Vec(0.3, 0.6)));
        assertEquals(new Pose(0.2, 0.4, 0), wall.pose());
        assertEquals(new ObstacleShape.Wall(List.of(new Vec(-0.1, -0.2), new Vec(0.1, 0.2))), wall.shape());
    }

    @Test
    void everyHandleOfATurnedRectangleLeavesTheOppositeOneWhereItIs() {
        Obstacle box = new Obstacle("box", new ObstacleShape.Rectangle(1, 0.5), new Pose(2, 1, Degrees.toRadians(30)));
        for (int handle = 0; handle < 8; handle++) {
            Vec opposite = ShapeHandles.places(box).get((handle + 4) % 8);
            Obstacle larger = ShapeHandles.dragged(box, handle, ShapeHandles.places(box).get(handle).times(1.1), Snap.NONE);
            assertEquals(0, ShapeHandles.places(larger).get((handle + 4) % 8).distanceTo(opposite), 1e-8);
        }
    }

    @Test
    void sizesSnapAndNeverVanish() {
        Obstacle pole = new Obstacle("pole", new ObstacleShape.Circle(0.2), new Pose(2, 1, 0));
        assertEquals(new ObstacleShape.Circle(0.35), ShapeHandles.dragged(pole, 0, new Vec(2.337, 1), new Snap(0.05, 0)).shape());
        assertEquals(new ObstacleShape.Circle(0.01), ShapeHandles.dragged(pole, 0, new Vec(2, 1), new Snap(0.05, 0)).shape());
    }

    @Test
    void aCornerOfAPolygonIsDraggedAlone() {
        Obstacle triangle = PointShapes.polygon("t", List.of(new Vec(0, 0), new Vec(2, 0), new Vec(0, 2)));
        Obstacle changed = ShapeHandles.dragged(triangle, 1, new Vec(3, 0.5), Snap.NONE);
        assertEquals(List.of(new Vec(0, 0), new Vec(3, 0.5), new Vec(0, 2)), ShapeHandles.places(changed));
    }

    @Test
    void aGlossyObstacleStaysGlossyWhenItIsCopiedAndReshaped() {
        Obstacle glass = new Obstacle("glass", new ObstacleShape.Rectangle(1, 0.5), new Pose(2, 1, 0), Optional.empty(), Degrees.toRadians(8));
        Obstacle copy = Copies.of(List.of(glass), Set.of("glass")).get(0);
        assertEquals(glass.specular(), copy.specular());
        assertEquals("glass-2", copy.id());
        assertEquals(glass.specular(), ShapeHandles.dragged(glass, 0, new Vec(3, 2), Snap.NONE).specular());
    }

    @Test
    void anIdThatIsTakenGetsTheNextNumber() {
        assertEquals("circle", FreshIds.like("circle", Set.of("box")));
        assertEquals("circle-3", FreshIds.like("circle", Set.of("circle", "circle-2")));
        assertEquals("circle-3", FreshIds.like("circle-2", Set.of("circle", "circle-2")));
    }
}
