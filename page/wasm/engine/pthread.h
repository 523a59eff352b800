// The engine includes this header, but has no threads here.
#pragma once
