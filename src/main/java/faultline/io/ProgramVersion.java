package faultline.io;

import java.util.Optional;

/** The version of this program, as its jar states it. */
public final class ProgramVersion {

    private ProgramVersion() {}

    /** {@return the version, such as 1.2.0; empty if the program does not run from a jar} */
    public static Optional<String> find() {
        return Optional.ofNullable(ProgramVersion.class.getPackage().getImplementationVersion());
    }

    /** {@return the name of the program and its version, for messages and files} */
    public static String text() {
        return "faultline " + find().orElse("(not from a jar)");
    }
}
