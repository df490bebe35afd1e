package faultline.campaign.run;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ShardTest {

    @Test
    void theShardsOfACampaignHaveEachRunOnce() {
        for (int count : new int[] {1, 2, 3, 7, 100}) {
            long next = 0;
            for (int number = 1; number <= count; number++) {
                Shard shard = new Shard(number, count);
                assertEquals(next, shard.firstRun(36));
                next = shard.endRun(36);
            }
            assertEquals(36, next);
        }
    }

    @Test
    void onlyPartsThatExistAreParsed() {
        assertEquals(Optional.of(new Shard(2, 4)), Shard.parse("2/4"));
        for (String text : new String[] {"", "2", "0/4", "5/4", "1/0", "-1/4", "1/4/5", "a/b", "99999999/1"}) {
            assertEquals(Optional.empty(), Shard.parse(text), text);
        }
    }

    @ParameterizedTest
    @CsvSource({"0, 4", "5, 4", "-1, 4", "1, 0"})
    void thereIsNoPartThatACampaignDoesNotHave(int number, int count) {
        IllegalArgumentException e = assertThrows(IllegalArgumentException.class, () -> new Shard(number, count));
        assertEquals("there is no part " + number + " of " + count, e.getMessage());
    }
}
