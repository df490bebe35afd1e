package faultline.io;

/** The command that starts this program, for commands that are shown to users. */
public final class ProgramCommand {

    private static final String PROPERTY = "faultline.command";
    private static final String JAR = "java -jar target/faultline.jar";

    private ProgramCommand() {}

    /** {@return the command of an installed package, whose launcher sets it, or else that of the built jar} */
    public static String text() {
        return System.getProperty(PROPERTY, JAR);
    }
}
