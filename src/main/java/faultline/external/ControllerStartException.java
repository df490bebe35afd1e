package faultline.external;

import faultline.engine.RunFailedException;
import faultline.io.Message;

/** Thrown if a controller does not exist or cannot be started. The message is one sentence for a user. */
public final class ControllerStartException extends RunFailedException {

    private static final long serialVersionUID = 1L;

    ControllerStartException(Message reason, Throwable cause) {
        super(reason, cause);
    }
}
