#pragma once

struct Silent {};
