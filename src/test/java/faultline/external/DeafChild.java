package faultline.external;

import java.io.IOException;

/** A child that answers each observation as soon as it arrives, but reads nothing, so that the pipe to it fills up. */
public final class DeafChild {

    private DeafChild() {}

    /** Waits for the hello and for each observation by the number of bytes that can be read. */
    public static void main(String[] args) throws IOException, InterruptedException {
        int arrived = awaitMore(0);
        System.out.println("{\"type\":\"ready\",\"protocol\":1}");
        for (long tick = 0; ; tick++) {
            arrived = awaitMore(arrived);
            System.out.println("{\"type\":\"drive\",\"tick\":" + tick + ",\"left_v\":1,\"right_v\":1}");
        }
    }

    private static int awaitMore(int arrived) throws IOException, InterruptedException {
        while (System.in.available() == arrived) {
            Thread.sleep(1);
        }
        return System.in.available();
    }
}
