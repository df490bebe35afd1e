package faultline.engine.walls;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.geometry.Vector2;
import java.util.List;
import java.util.stream.DoubleStream;
import org.junit.jupiter.api.Test;

class JoinedPlacesTest {

    /** Returns places on the x axis that are joined up to 0.1 m. */
    private static JoinedPlaces at(double... xs) {
        List<WallReference.WallSample> places = DoubleStream.of(xs)
                .mapToObj(x -> new WallReference.WallSample(new Vector2(x, 0), new Vector2(0, 1), 0))
                .toList();
        return new JoinedPlaces(places, 0.1);
    }

    @Test
    void placesUpToTheDistanceBelongToOnePath() {
        JoinedPlaces places = at(0, 0.3, 0.09, 0.18, 0.18);
        assertEquals(
                List.of(0, 1, 0, 0, 0),
                List.of(0, 1, 2, 3, 4).stream().map(places::path).toList());
    }

    @Test
    void thePathNearAPointIsThatOfTheNearestPlace() {
        JoinedPlaces places = at(0, 0.09, 0.21);
        assertEquals(2, places.pathNear(new Vector2(0.16, 0)));
        assertEquals(0, places.pathNear(new Vector2(0.13, 0)));
        assertEquals(0, places.pathNear(new Vector2(0.08, 0)));
        assertEquals(JoinedPlaces.NONE, places.pathNear(new Vector2(0.4, 0)));
        assertEquals(JoinedPlaces.NONE, places.pathNear(new Vector2(0.4, 0.5)));
        assertEquals(2, places.pathNear(new Vector2(0.2, 0)));
    }
}
