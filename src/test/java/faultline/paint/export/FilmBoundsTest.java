package faultline.paint.export;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.geom.Rectangle2D;
import java.util.HashSet;
import java.util.Set;
import org.junit.jupiter.api.Test;

class FilmBoundsTest {

    private final FilmBounds film = new FilmBounds();

    @Test
    void aFilmOfAWorldThatNothingLeavesShowsTheWorld() {
        Rectangle2D world = new Rectangle2D.Double(0, 0, 6, 4);
        assertSame(world, film.next(world));
        assertSame(world, film.next(new Rectangle2D.Double(0, 0, 6, 4)));
    }

    @Test
    void theBoundsChangeRarelyWhileARobotDrivesAway() {
        Set<Rectangle2D> all = new HashSet<>();
        for (int i = 0; i <= 10_000; i++) {
            Rectangle2D needed = new Rectangle2D.Double(0, 0, 2 + 0.03 * i, 2);
            Rectangle2D shown = film.next(needed);
            assertTrue(shown.contains(needed), shown::toString);
            all.add(shown);
        }
        assertEquals(12, all.size(), 6);
    }
}
