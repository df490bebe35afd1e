package faultline.external;

import java.io.IOException;
import java.util.List;

/** Starts a child while the program is ending. Its first argument is the child's, by which the child can be found. */
public final class LateChild {

    private LateChild() {}

    /** Ends, and starts a child in a shutdown hook, as another thread may do at that time. */
    public static void main(String[] args) {
        Runtime.getRuntime().addShutdownHook(new Thread(() -> start(args[0])));
    }

    @SuppressWarnings("resource")
    private static void start(String argument) {
        try {
            new ChildProcess(List.of("sleep", argument), 1, line -> {});
        } catch (IOException e) {
            System.out.println(e.getMessage());
        }
    }
}
