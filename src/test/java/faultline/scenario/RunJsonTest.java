package faultline.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;

/** The summary of a run as JSON; every value differs from the others. */
class RunJsonTest {

    @Test
    void everyKeyHasItsValue() {
        assertEquals(
                "{\"ticks\":250,\"simulated_s\":2.5,\"real_time_factor\":12.25,\"state\":\"FOLLOW\","
                        + "\"states\":[\"SEARCH\",\"FOLLOW\"],\"collision\":{\"x_m\":1.5,\"y_m\":0.25,\"t_s\":2.25},"
                        + "\"collided_with\":\"pole\",\"coverage\":0.75,\"distance_rms_m\":0.003,"
                        + "\"follow_rms_m\":0.0045,\"trajectory_hash\":\"00000000000000ff\",\"seed\":7,"
                        + "\"rung\":\"THREE\",\"rung_changes\":[\"THREE at 0.75\"],"
                        + "\"health_changes\":[\"left OFF at 0.5\",\"left trusted at 2\"],"
                        + "\"truth\":true,\"expectations\":\"failed\",\"unmet\":[\"it was slow\"]}",
                RunJson.format(SampleResults.eventful(), true, List.of("it was slow")));
    }

    @Test
    void aMissingValueIsNull() {
        assertEquals(
                "{\"ticks\":0,\"simulated_s\":0,\"real_time_factor\":null,\"state\":\"SEARCH\",\"states\":[\"SEARCH\"],"
                        + "\"collision\":null,\"collided_with\":null,\"coverage\":null,\"distance_rms_m\":null,"
                        + "\"follow_rms_m\":null,\"trajectory_hash\":\"0000000000000001\",\"seed\":1,\"rung\":null,"
                        + "\"rung_changes\":[],\"health_changes\":[],\"truth\":false,\"expectations\":\"held\","
                        + "\"unmet\":[]}",
                RunJson.format(SampleResults.uneventful(), false, List.of()));
    }
}
